#include "tests/import/memory/packed_zeros.h"

#include <array>
#include <initializer_list>
#include <memory>
#include <string_view>

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

namespace throng::import::testing {
namespace {

/// Appends bits, the lowest of a byte first.
class BitWriter {
 public:
  void put(std::uint32_t bits, int count) {
    for (int i = 0; i < count; ++i, ++used_) {
      if (used_ % 8 == 0) bytes_.push_back(0);
      bytes_.back() = static_cast<char>(static_cast<unsigned char>(bytes_.back()) | ((bits >> i & 1U) << (used_ % 8)));
    }
  }
  std::vector<char> take() { return std::move(bytes_); }

 private:
  std::vector<char> bytes_;
  std::size_t used_ = 0;
};

/// Returns at least `count` zeros as a zlib stream (RFC 1950 and 1951): one zero, and copies of 258 from a byte before.
std::vector<char> zlib_of_zeros(std::size_t count) {
  BitWriter bits;
  bits.put(0x0178, 16);  // deflate, window of 32 KiB
  bits.put(0b011, 3);    // the last block, fixed codes
  bits.put(0b00001100, 8);
  for (std::size_t written = 1; written < count; written += 258) {
    bits.put(0b10100011, 8);  // a length of 258
    bits.put(0, 5);           // a distance of 1
  }
  bits.put(0, 7);  // the end of the block
  bits.put(0, 32);
  return bits.take();
}

void append(std::vector<char>& bytes, std::initializer_list<int> values) {
  for (const int value : values) bytes.push_back(static_cast<char>(value));
}

void append_word(std::vector<char>& bytes, std::uint32_t word) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>(word >> shift & 0xFFU));
}

/// The sum at the end stays 0; what decodes images here does not read it.
void append_chunk(std::vector<char>& png, std::string_view type, const std::vector<char>& content) {
  append_word(png, static_cast<std::uint32_t>(content.size()));
  png.insert(png.end(), type.begin(), type.end());
  png.insert(png.end(), content.begin(), content.end());
  append_word(png, 0);
}

}  // namespace

std::vector<char> png_of_zeros(std::uint32_t width, std::uint32_t height, bool has_channels, std::size_t more) {
  std::vector<char> png;
  append(png, {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'});
  std::vector<char> header;
  append_word(header, width);
  append_word(header, height);
  if (has_channels) {
    append(header, {8, 6, 0, 0, 0});
  } else {
    append(header, {1, 0, 0, 0, 0});
  }
  append_chunk(png, "IHDR", header);
  const std::size_t row = 1 + (has_channels ? std::size_t{width} * 4 : (std::size_t{width} + 7) / 8);
  append_chunk(png, "IDAT", zlib_of_zeros(row * height + more));
  append_chunk(png, "IEND", {});
  return png;
}

std::vector<char> jpeg_of_zeros(std::uint16_t width, std::uint16_t height) {
  std::vector<char> jpeg;
  append(jpeg, {0xFF, 0xD8, 0xFF, 0xDB, 0, 67, 0});
  jpeg.insert(jpeg.end(), 64, 1);
  append(jpeg, {0xFF, 0xC0, 0, 11, 8, height >> 8, height & 0xFF, width >> 8, width & 0xFF, 1, 1, 0x11, 0});
  for (const int table : {0x00, 0x10}) {  // of direct and of alternating parts: one code, a zero
    append(jpeg, {0xFF, 0xC4, 0, 20, table, 1});
    jpeg.insert(jpeg.end(), 15, 0);
    append(jpeg, {0});
  }
  append(jpeg, {0xFF, 0xDA, 0, 8, 1, 1, 0x00, 0, 63, 0, 0xFF, 0xD9});
  return jpeg;
}

std::vector<char> webp_of_zeros(std::uint32_t width, std::uint32_t height) {
  BitWriter bits;
  bits.put(0x2F, 8);
  bits.put(width - 1, 14);
  bits.put(height - 1, 14);
  bits.put(1, 1);                                   // has alpha
  bits.put(0, 3 + 3);                               // version; no transform, no cache of colours, one set of codes
  for (int i = 0; i < 5; ++i) bits.put(0b0001, 4);  // a simple code of one symbol, which is 0 and takes no bit
  bits.put(0, 64);
  const std::vector<char> content = bits.take();
  const int size = static_cast<int>(content.size() + content.size() % 2);
  std::vector<char> webp;
  append(webp, {'R', 'I', 'F', 'F', size + 12, 0, 0, 0, 'W', 'E', 'B', 'P', 'V', 'P', '8', 'L', size, 0, 0, 0});
  webp.insert(webp.end(), content.begin(), content.end());
  if (content.size() % 2 == 1) webp.push_back(0);
  return webp;
}

std::vector<char> meshopt_of_zeros(std::size_t count) {
  using Element = std::array<std::uint8_t, 64>;
  const std::vector<Element> elements(count);
  std::vector<char> bytes(meshopt_encodeVertexBufferBound(count, sizeof(Element)));
  bytes.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(), elements.data(),
                                          count, sizeof(Element)));
  return bytes;
}

std::vector<char> draco_square(std::uint32_t side, std::int8_t channels) {
  using Corner = std::array<float, 3>;
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(static_cast<int>(side * side * 2));
  const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const std::array<std::uint8_t, 100> zeros{};
  const int more =
      channels > 0 ? builder.AddAttribute(draco::GeometryAttribute::GENERIC, channels, draco::DT_UINT8) : position;
  const auto corner = [](std::uint32_t x, std::uint32_t y) {
    return Corner{static_cast<float>(x), static_cast<float>(y), 0.0F};
  };
  for (std::uint32_t face = 0; face < side * side; ++face) {
    const std::uint32_t x = face % side, y = face / side;
    const Corner a = corner(x, y), b = corner(x + 1, y), c = corner(x, y + 1), d = corner(x + 1, y + 1);
    builder.SetAttributeValuesForFace(position, draco::FaceIndex(face * 2), a.data(), b.data(), c.data());
    builder.SetAttributeValuesForFace(position, draco::FaceIndex(face * 2 + 1), b.data(), d.data(), c.data());
    for (const std::uint32_t each : {face * 2, face * 2 + 1}) {
      if (more != position) {
        builder.SetAttributeValuesForFace(more, draco::FaceIndex(each), zeros.data(), zeros.data(), zeros.data());
      }
    }
  }
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  draco::Encoder encoder;
  encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 12);
  draco::EncoderBuffer encoded;
  if (!encoder.EncodeMeshToBuffer(*mesh, &encoded).ok()) return {};
  return {encoded.data(), encoded.data() + encoded.size()};
}

}  // namespace throng::import::testing
