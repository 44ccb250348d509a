#include "engine/anim/import/pixels/jpeg_tables.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>
#include <malloc.h>

#include "engine/anim/import/pixels/decode.h"
#include "tests/import/test_files.h"

namespace throng::import::testing::jpeg_tables_test {
namespace {

std::vector<char> small_jpeg() { return read_bytes(data_path("fuzz/image/colour.jpg")); }

/// Lets the first Huffman table say that it has this many codes of 16 bits, the longest.
std::vector<char> with_longest_codes(std::vector<char> jpeg, unsigned char codes) {
  constexpr std::array<char, 2> tables{'\xFF', '\xC4'};
  const auto at = std::search(jpeg.begin(), jpeg.end(), tables.begin(), tables.end());
  at[20] = static_cast<char>(codes);  // marker, length and number of the table, then a count for each length
  return jpeg;
}

TEST(JpegTables, FitInAJpegThatDecodes) {
  const std::vector<char> jpeg = small_jpeg();
  EXPECT_TRUE(jpeg_tables_fit(std::as_bytes(std::span(jpeg))));
  EXPECT_TRUE(decode_image(std::as_bytes(std::span(jpeg)), 1 << 20));
}

TEST(JpegTables, WithMoreCodesThanThereAreBytesAreRefused) {
  const std::vector<char> jpeg = with_longest_codes(small_jpeg(), 255);
  const auto image = decode_image(std::as_bytes(std::span(jpeg)), 1 << 20);
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().message, "a Huffman table of its JPEG has more than 256 codes");
}

std::vector<char> without_huffman_tables(std::vector<char> jpeg) {
  constexpr std::array<char, 2> tables{'\xFF', '\xC4'};
  for (;;) {
    const auto at = std::search(jpeg.begin(), jpeg.end(), tables.begin(), tables.end());
    if (at == jpeg.end()) return jpeg;
    const auto high = static_cast<unsigned char>(at[2]), low = static_cast<unsigned char>(at[3]);
    jpeg.erase(at, at + 2 + high * 256 + low);
  }
}

std::vector<std::uint8_t> decoded(const std::vector<char>& jpeg) {
  const auto image = decode_image(std::as_bytes(std::span(jpeg)), 1 << 20);
  if (!image) return {};
  return {image->rgba.begin(), image->rgba.end()};
}

/// Lets memory that malloc gives hold one byte while it lives.
class FilledMemory {
 public:
  explicit FilledMemory(int byte) { mallopt(M_PERTURB, byte ^ 0xFF); }
  FilledMemory(const FilledMemory&) = delete;
  FilledMemory& operator=(const FilledMemory&) = delete;
  ~FilledMemory() { mallopt(M_PERTURB, 0); }
};

std::vector<std::uint8_t> decoded_in_memory_of(int byte, const std::vector<char>& jpeg) {
  const FilledMemory memory(byte);
  return decoded(jpeg);
}

TEST(JpegTables, ThatAreNotThereAreNotWhatMemoryHeldBefore) {
  const std::vector<char> jpeg = without_huffman_tables(small_jpeg());
  EXPECT_EQ(decoded_in_memory_of(1, jpeg), decoded_in_memory_of(2, jpeg));
}

TEST(JpegTables, AreFoundBehindBytesThatFill) {
  std::vector<char> jpeg = with_longest_codes(small_jpeg(), 255);
  jpeg.insert(jpeg.begin(), '\xFF');
  EXPECT_FALSE(jpeg_tables_fit(std::as_bytes(std::span(jpeg))));
}

TEST(JpegTables, OfBytesThatAreNoJpegFit) {
  const std::vector<char> text{'F', 'o', 'x'};
  EXPECT_TRUE(jpeg_tables_fit(std::as_bytes(std::span(text))));
  EXPECT_TRUE(jpeg_tables_fit({}));
}

}  // namespace
}  // namespace throng::import::testing::jpeg_tables_test
