#include "throng/render/image.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <csetjmp>
#include <cstring>
#include <string>
#include <string_view>

#include <png.h>

#include "engine/base/files/input_file.h"
#include "engine/base/files/output_file.h"

namespace throng::render {

Image Image::blank(int width, int height) {
  assert(width > 0 && height > 0);
  Image image{width, height, {}};
  image.rgba.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, 255);
  return image;
}

NumberImage in_16_bits(const Image& image) {
  NumberImage deep{.width = image.width, .height = image.height, .numbers = {}, .channels = 4};
  deep.numbers.resize(image.rgba.size());
  std::ranges::transform(image.rgba, deep.numbers.begin(),
                         [](std::uint8_t value) { return static_cast<std::uint16_t>(value * deep_steps); });
  return deep;
}

Image in_8_bits(const NumberImage& image) {
  Image shallow = Image::blank(image.width, image.height);
  for (std::size_t i = 0; i < shallow.rgba.size(); ++i) {
    if (image.channels == 1 && i % 4 == 3) continue;  // grey hides what is behind it
    const int number = image.numbers[image.channels == 1 ? i / 4 : i];
    shallow.rgba[i] = static_cast<std::uint8_t>((number + deep_steps / 2) / deep_steps);
  }
  return shallow;
}

namespace {

constexpr std::size_t most_png_bytes = std::size_t{1} << 30U;
constexpr std::uint64_t most_pixels = std::uint64_t{1} << 28U;  // of a square of 16,384

/// A PNG on its way out of memory. libpng leaves by a jump when something fails, so no object is made meanwhile.
struct PngReader {
  std::span<const std::byte> left;
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string complaint;

  explicit PngReader(std::span<const std::byte> bytes) : left(bytes) {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, ignore);
    if (png != nullptr) info = png_create_info_struct(png);
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }

  static void ignore(png_structp /*png*/, png_const_charp /*warning*/) {}
  static void fail(png_structp png, png_const_charp why) {
    static_cast<PngReader*>(png_get_error_ptr(png))->complaint = why;
    longjmp(png_jmpbuf(png), 1);
  }
  static void give(png_structp png, png_bytep bytes, std::size_t count) {
    auto* const reader = static_cast<PngReader*>(png_get_io_ptr(png));
    if (reader->left.size() < count) png_error(png, "it ends too early");
    std::memcpy(bytes, reader->left.data(), count);
    reader->left = reader->left.subspan(count);
  }

  /// Returns whether there are pixels, and says of which form `image` will be.
  bool begin(NumberImage& image) {
    if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_read_fn(png, this, give);
    png_read_info(png, info);
    image.width = static_cast<int>(png_get_image_width(png, info));
    image.height = static_cast<int>(png_get_image_height(png, info));
    constexpr png_uint_32 colour = PNG_INFO_gAMA | PNG_INFO_sRGB | PNG_INFO_iCCP | PNG_INFO_tRNS;
    image.channels = 1;
    if (png_get_bit_depth(png, info) != 16 || png_get_color_type(png, info) != PNG_COLOR_TYPE_GRAY ||
        png_get_valid(png, info, colour) != 0) {
      image.channels = 4;
      png_set_alpha_mode(png, PNG_ALPHA_PNG, PNG_DEFAULT_sRGB);
      png_set_expand_16(png);
      png_set_gray_to_rgb(png);
      png_set_add_alpha(png, 0xFFFF, PNG_FILLER_AFTER);
    }
    if (std::endian::native == std::endian::little) png_set_swap(png);
    return true;
  }

  bool read_rows(NumberImage& image) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    const int passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    for (int pass = 0; pass < passes; ++pass) {
      for (int row = 0; row < image.height; ++row) {
        png_read_row(png, reinterpret_cast<png_bytep>(image.pixel(0, row)), nullptr);
      }
    }
    return true;
  }
};

/// A PNG on its way into a file, with jumps as above.
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

  void begin(int width, int height, int bits, int color_type, std::span<png_text> texts) {
    png_set_write_fn(png, this, take, nullptr);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), bits, color_type,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (color_type == PNG_COLOR_TYPE_RGB_ALPHA) png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_text(png, info, texts.data(), static_cast<int>(texts.size()));
    png_write_info(png, info);
  }

  bool write(const Image& image, std::span<png_text> texts) {
    if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) return false;
    begin(image.width, image.height, 8, PNG_COLOR_TYPE_RGB_ALPHA, texts);
    for (int row = 0; row < image.height; ++row) png_write_row(png, image.pixel(0, row));
    png_write_end(png, info);
    return true;
  }

  bool write(const NumberImage& image, std::span<png_text> texts) {
    if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) return false;
    begin(image.width, image.height, 16, image.channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB_ALPHA, texts);
    if (std::endian::native == std::endian::little) png_set_swap(png);
    for (int row = 0; row < image.height; ++row) {
      png_write_row(png, reinterpret_cast<png_const_bytep>(image.pixel(0, row)));
    }
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

Status write_whole_png(const auto& image, const std::filesystem::path& file, std::span<const PngText> texts) {
  auto output = OutputFile::create(file);
  if (!output) return output.error();
  std::vector<png_text> lent = lent_to_libpng(texts);
  PngWriter writer(*output);
  if (!writer.write(image, lent)) {
    return writer.outcome ? Error{file.string() + ": cannot be written: there is no memory left"} : writer.outcome;
  }
  return output->commit();
}

}  // namespace

Result<NumberImage> read_any_png(const std::filesystem::path& file) {
  const auto failed = [&](const std::string& why) { return Error{"cannot read image " + file.string() + ": " + why}; };
  const auto bytes = read_file(file, "a .png", most_png_bytes);
  if (!bytes) return failed(bytes.error().message);
  constexpr std::size_t signature_bytes = 8;
  const bool is_png = bytes->size() >= signature_bytes &&
                      png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes->data()), 0, signature_bytes) == 0;
  if (!is_png) return failed("it is no PNG; name one");
  PngReader reader(*bytes);
  NumberImage image;
  if (!reader.begin(image)) return failed(reader.complaint);
  const std::uint64_t pixels = static_cast<std::uint64_t>(image.width) * static_cast<std::uint64_t>(image.height);
  if (pixels > most_pixels) {
    return failed("it is " + std::to_string(image.width) + " by " + std::to_string(image.height) +
                  " pixels by its header, and 16384 by 16384 are the most; scale it down");
  }
  image.numbers.resize(pixels * static_cast<std::size_t>(image.channels));
  if (!reader.read_rows(image)) return failed(reader.complaint);
  return image;
}

Result<Image> read_png(const std::filesystem::path& file) {
  const auto image = read_any_png(file);
  if (!image) return image.error();
  return in_8_bits(*image);
}

bool is_whole_png(const std::filesystem::path& file, int width, int height) {
  constexpr std::size_t sizes_at = 16, head_bytes = 24, tail_bytes = 8;
  auto input = InputFile::open(file, "a .png");
  std::array<std::byte, head_bytes> head{};
  std::array<std::byte, tail_bytes> tail{};
  if (!input || input->size() < head_bytes + tail_bytes) return false;
  if (const auto read = input->read(head); !read || *read != head.size()) return false;
  if (!input->go_to(input->size() - tail_bytes)) return false;
  if (const auto read = input->read(tail); !read || *read != tail.size()) return false;
  const auto side_at = [&](std::size_t place) {
    std::uint32_t side = 0;
    for (std::size_t i = 0; i < sizeof(side); ++i) side = side << 8U | std::to_integer<std::uint32_t>(head[place + i]);
    return side;
  };
  constexpr std::string_view end = "IEND\xAE\x42\x60\x82";
  return png_sig_cmp(reinterpret_cast<png_const_bytep>(head.data()), 0, 8) == 0 &&
         side_at(sizes_at) == static_cast<std::uint32_t>(width) &&
         side_at(sizes_at + 4) == static_cast<std::uint32_t>(height) &&
         std::memcmp(tail.data(), end.data(), tail.size()) == 0;
}

Status write_png(const Image& image, const std::filesystem::path& file, std::span<const PngText> texts) {
  return write_whole_png(image, file, texts);
}
Status write_png(const NumberImage& image, const std::filesystem::path& file, std::span<const PngText> texts) {
  return write_whole_png(image, file, texts);
}

}  // namespace throng::render
