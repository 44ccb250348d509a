#include "engine/render/image.h"

#include <cassert>
#include <csetjmp>
#include <memory>
#include <string>
#include <vector>

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

namespace {

/// A PNG on its way into a file. libpng leaves by a jump when something fails, so no object is made meanwhile.
struct PngWriter {
  OutputFile* output;
  png_structp png = nullptr;
  png_infop info = nullptr;
  Status outcome = Done{};

  explicit PngWriter(OutputFile& file) : output(&file) {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, this, fail, nullptr);
    if (png != nullptr) info = png_create_info_struct(png);
  }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
  ~PngWriter() { png_destroy_write_struct(&png, &info); }

  static void fail(png_structp png, png_const_charp why) {
    Status& outcome = static_cast<PngWriter*>(png_get_error_ptr(png))->outcome;
    if (outcome) outcome = Error{why};
    longjmp(png_jmpbuf(png), 1);
  }
  static void take(png_structp png, png_bytep bytes, std::size_t count) {
    auto* const writer = static_cast<PngWriter*>(png_get_io_ptr(png));
    writer->outcome = writer->output->write({reinterpret_cast<const char*>(bytes), count});
    if (!writer->outcome) png_error(png, "");
  }

  bool write(const Image& image, std::span<png_text> texts) {
    if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_write_fn(png, this, take, nullptr);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
                 PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_text(png, info, texts.data(), static_cast<int>(texts.size()));
    png_write_info(png, info);
    for (int row = 0; row < image.height; ++row) png_write_row(png, image.pixel(0, row));
    png_write_end(png, info);
    return true;
  }
};

/// Returns the texts as libpng takes them, which copies all but the letters.
std::vector<png_text> lent_to_libpng(std::span<const PngText> texts) {
  std::vector<png_text> lent;
  for (const PngText& each : texts) {
    png_text& text = lent.emplace_back();
    text.compression = PNG_TEXT_COMPRESSION_NONE;
    text.key = const_cast<png_charp>(each.keyword.c_str());
    text.text = const_cast<png_charp>(each.text.c_str());
    text.text_length = each.text.size();
  }
  return lent;
}

}  // namespace

Status write_png(const Image& image, const std::filesystem::path& file, std::span<const PngText> texts) {
  auto output = OutputFile::create(file);
  if (!output) return output.error();
  std::vector<png_text> lent = lent_to_libpng(texts);
  PngWriter writer(*output);
  if (!writer.write(image, lent)) {
    return writer.outcome ? Error{file.string() + ": cannot be written: there is no memory left"} : writer.outcome;
  }
  return output->commit();
}

}  // namespace throng::render
