#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "engine/anim/import/bytes/meshopt_attributes.h"
#include "engine/anim/import/bytes/meshopt_codec.h"
#include "engine/anim/import/bytes/refusal.h"
#include "tests/import/test_files.h"

namespace throng::import::testing::meshopt_test {
namespace {

using ::testing::IsEmpty;

struct Element {
  std::uint16_t a, b;
  float c;
};

/// Forty elements i: 37 i, i squared, i / 4, as a later meshoptimizer packs them at its highest level. Control modes 0,
/// 1, 2 and 3, and channels of two bytes and of rotated words are among them.
constexpr std::string_view packed =
    "a1bb68004a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a0002060a0e12161a1e22262a"
    "2e32363a3e42464a4e52565a5e62666a6e72767a7e82868a8e92969a0102010f1f1a0ffff8f8f4c4f4c4a060103018f81cf262e262f262"
    "e2623c1edddd00007e030703000000000000000000000000000000000000000000000162";

std::vector<std::byte> bytes_of(std::string_view digits) {
  std::vector<std::byte> bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    bytes.push_back(static_cast<std::byte>(std::stoi(std::string(digits.substr(i, 2)), nullptr, 16)));
  }
  return bytes;
}

MeshoptView view_of(const std::vector<std::byte>& bytes, const std::string& filter = "NONE") {
  return {.bytes = bytes, .count = 40, .stride = sizeof(Element), .mode = "ATTRIBUTES", .filter = filter};
}

TEST(MeshoptAttributes, OfVersionOneAreWhatWasPacked) {
  const std::vector<std::byte> elements = decode_meshopt(view_of(bytes_of(packed)));
  ASSERT_EQ(elements.size(), 40 * sizeof(Element));
  for (std::size_t i = 0; i < 40; ++i) {
    Element element;
    std::memcpy(&element, elements.data() + i * sizeof element, sizeof element);
    EXPECT_EQ(element.a, i * 37);
    EXPECT_EQ(element.b, i * i);
    EXPECT_EQ(element.c, 0.25F * static_cast<float>(i));
  }
}

TEST(MeshoptAttributes, OfVersionOneAreRefusedWhereTheyEndTooEarlyOrTooLate) {
  std::vector<std::byte> bytes = bytes_of(packed);
  bytes.insert(bytes.begin() + 60, std::byte{0});
  EXPECT_THROW(decode_meshopt(view_of(bytes)), Refusal);
  for (std::size_t size = 1; size < packed.size() / 2; ++size) {
    std::vector<std::byte> cut = bytes_of(packed);
    cut.resize(size);
    EXPECT_THROW(decode_meshopt(view_of(cut)), Refusal) << size;
  }
  bytes = bytes_of(packed);
  bytes.back() = std::byte{3};
  EXPECT_THROW(decode_meshopt(view_of(bytes)), Refusal) << "there is no such mode of a channel";
}

TEST(MeshoptAttributes, OfVersionOneAreNoHarmWhateverIsDamaged) {
  std::mt19937 random(20261125);
  for (int round = 0; round < 5000; ++round) {
    std::vector<std::byte> bytes = bytes_of(packed);
    for (unsigned left = 1 + random() % 4; left > 0; --left) {
      bytes[random() % bytes.size()] = static_cast<std::byte>(random());
    }
    try {
      decode_meshopt(view_of(bytes));
    } catch (const Refusal&) {
    }
  }
}

TEST(MeshoptColours, AreRedGreenBlueAndAlpha) {
  // One, a half, a quarter, one; nothing at all; 0.1, 0.9, 0.3, 0.5; white.
  std::array<std::uint8_t, 16> colors{144, 95, 241, 255, 0, 0, 0, 128, 141, 231, 89, 192, 255, 0, 0, 255};
  decode_color_filter(std::as_writable_bytes(std::span(colors)), 4);
  EXPECT_THAT(colors, ::testing::ElementsAre(254, 129, 64, 255, 0, 0, 0, 0, 27, 230, 77, 128, 255, 255, 255, 255));
}

TEST(MeshoptViews, ReadAlikeUnderBothNames) {
  const std::vector<char> buffer = editable_buffer();
  std::vector<char> times(meshopt_encodeVertexBufferBound(4, 16));
  times.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(times.data()), times.size(),
                                          buffer.data() + 2208, 4, 16));
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    nlohmann::json document = editable_document();
    document["buffers"].push_back({{"byteLength", times.size()}, {"uri", "packed.bin"}});
    document["bufferViews"][5]["extensions"][name] = {
        {"buffer", 1}, {"byteLength", times.size()}, {"byteStride", 16}, {"count", 4}, {"mode", "ATTRIBUTES"}};
    document["extensionsRequired"] = {name};
    const TemporaryFolder folder;
    folder.write("packed.bin", times);
    EXPECT_THAT(import_good(folder.write("model.gltf", document.dump())).repairs, IsEmpty()) << name;
  }
}

}  // namespace
}  // namespace throng::import::testing::meshopt_test
