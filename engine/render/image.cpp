#include "engine/render/image.h"

#include <cassert>
#include <string>
#include <system_error>

#include <png.h>

namespace throng::render {

Image Image::blank(int width, int height) {
  assert(width > 0 && height > 0);
  Image image{width, height, {}};
  image.rgba.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, 255);
  return image;
}

Result<Image> read_png(const std::filesystem::path& file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const auto failed = [&] { return Error{"cannot read image " + file.string() + ": " + png.message}; };
  if (png_image_begin_read_from_file(&png, file.c_str()) == 0) return failed();
  png.format = PNG_FORMAT_RGBA;
  Image image = Image::blank(static_cast<int>(png.width), static_cast<int>(png.height));
  if (png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr) == 0) return failed();
  return image;
}

Status write_png(const Image& image, const std::filesystem::path& file) {
  std::filesystem::path unfinished = file;
  unfinished += ".unfinished";
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGBA;
  std::error_code failure;
  if (png_image_write_to_file(&png, unfinished.c_str(), 0, image.rgba.data(), 0, nullptr) == 0) {
    std::filesystem::remove(unfinished, failure);
    return Error{"cannot write image " + file.string() + "; check that its folder exists and is writable"};
  }
  std::filesystem::rename(unfinished, file, failure);
  if (!failure) return Done{};
  const std::string reason = failure.message();
  std::filesystem::remove(unfinished, failure);
  return Error{"cannot write image " + file.string() + ": " + reason};
}

}  // namespace throng::render
