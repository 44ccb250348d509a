#include "engine/render/image.h"

#include <cassert>
#include <memory>
#include <string>
#include <string_view>

#include <png.h>

#include "engine/files/input_file.h"
#include "engine/files/output_file.h"

namespace throng::render {

Image Image::blank(int width, int height) {
  assert(width > 0 && height > 0);
  Image image{width, height, {}};
  image.rgba.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, 255);
  return image;
}

namespace {

struct FreeImage {
  void operator()(png_image* png) const { png_image_free(png); }
};

std::unique_ptr<png_image, FreeImage> owned(png_image& png) {
  png.version = PNG_IMAGE_VERSION;
  return std::unique_ptr<png_image, FreeImage>(&png);
}

}  // namespace

Result<Image> read_png(const std::filesystem::path& file) {
  constexpr std::size_t most_bytes = std::size_t{1} << 30U;
  const auto failed = [&](const std::string& why) { return Error{"cannot read image " + file.string() + ": " + why}; };
  const auto bytes = read_file(file, "a .png", most_bytes);
  if (!bytes) return failed(bytes.error().message);
  png_image png{};
  const auto freed = owned(png);
  if (png_image_begin_read_from_memory(&png, bytes->data(), bytes->size()) == 0) return failed(png.message);
  png.format = PNG_FORMAT_RGBA;
  Image image = Image::blank(static_cast<int>(png.width), static_cast<int>(png.height));
  if (png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr) == 0) return failed(png.message);
  return image;
}

Status write_png(const Image& image, const std::filesystem::path& file) {
  png_image png{};
  const auto freed = owned(png);
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgba.data(), 0, nullptr) == 0) {
    return Error{"cannot write image " + file.string() + ": " + png.message};
  }
  return write_whole_file(file, std::string_view(bytes).substr(0, size));
}

}  // namespace throng::render
