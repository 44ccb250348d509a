#include "engine/anim/pack/sections.h"

#include <algorithm>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/base/aligned_bytes.h"

namespace throng::pack::sections_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr std::uint64_t layout = 42;

/// A pack of two sections, one of which is followed by padding, in memory that may be changed.
class SmallPack {
 public:
  explicit SmallPack(std::uint32_t version = pack_version) {
    const std::vector<std::byte> first(100, std::byte{1}), second(64, std::byte{2});
    const SectionBytes sections[] = {{SectionKind::model, 0, 0, first}, {SectionKind::clips, 0, 1, second}};
    const std::vector<std::byte> joined = join_sections(sections, layout, version);
    size_ = joined.size();
    bytes_ = anim::allocate_aligned(size_);
    std::memcpy(bytes_.get(), joined.data(), size_);
  }
  std::span<std::byte> bytes() { return {bytes_.get(), size_}; }
  PackHeader& header() { return *reinterpret_cast<PackHeader*>(bytes_.get()); }
  std::string refusal(std::uint64_t wanted = layout) {
    const auto checked = check_sections(bytes(), wanted);
    return checked ? "(accepted)" : checked.error().message;
  }

 private:
  anim::AlignedBytes bytes_;
  std::size_t size_ = 0;
};

TEST(Sections, LieFromMultiplesOf64Bytes) {
  SmallPack pack;
  const auto sections = check_sections(pack.bytes(), layout);
  ASSERT_TRUE(sections);
  ASSERT_EQ(sections->size(), 2U);
  EXPECT_EQ((*sections)[0].offset, 128U);
  EXPECT_EQ((*sections)[0].size, 100U);
  EXPECT_EQ((*sections)[1].kind, SectionKind::clips);
  EXPECT_EQ((*sections)[1].model, 1U);
  EXPECT_EQ((*sections)[1].offset, 256U);
  EXPECT_EQ(pack.bytes()[256], std::byte{2});
}

TEST(Sections, AreRefusedWithAnyBitFlipped) {
  SmallPack pack;
  for (std::size_t byte = 0; byte < pack.bytes().size(); ++byte) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      pack.bytes()[byte] ^= std::byte{1} << bit;
      EXPECT_NE(pack.refusal(), "(accepted)") << byte << " " << bit;
      pack.bytes()[byte] ^= std::byte{1} << bit;
    }
  }
  EXPECT_EQ(pack.refusal(), "(accepted)");
}

TEST(Sections, AreRefusedWithSeveralBitsFlipped) {
  SmallPack pack;
  std::mt19937 random(1);
  for (int trial = 0; trial < 20'000; ++trial) {
    const std::vector<std::byte> before(pack.bytes().begin(), pack.bytes().end());
    for (int flip = 0; flip < 3; ++flip) pack.bytes()[random() % before.size()] ^= std::byte{1} << random() % 8;
    const bool changed = !std::ranges::equal(before, pack.bytes());
    EXPECT_EQ(pack.refusal() != "(accepted)", changed);
    std::ranges::copy(before, pack.bytes().begin());
  }
}

TEST(Sections, AreRefusedCutShortAnywhere) {
  SmallPack pack;
  for (std::size_t size = 0; size < pack.bytes().size(); ++size) {
    const auto checked = check_sections(pack.bytes().first(size), layout);
    ASSERT_FALSE(checked) << size;
    if (size >= sizeof(PackHeader)) {
      EXPECT_THAT(checked.error().message, StartsWith("it is cut short: ")) << size;
    }
  }
}

TEST(Sections, OfAnotherMachineOrVersionAreToldFromDamage) {
  SmallPack pack;
  EXPECT_THAT(pack.refusal(layout + 1), HasSubstr("another version of throng, whose tables differ"));
  pack.header().byte_order = 0x04030201;
  EXPECT_THAT(pack.refusal(), HasSubstr("machines of the other byte order"));
}

TEST(Sections, SayWhichVersionTheyHave) {
  EXPECT_THAT(SmallPack(7).refusal(), HasSubstr("another version of throng (its form is number 7, this one reads"));
  SmallPack damaged;
  damaged.header().version = 7;
  EXPECT_THAT(damaged.refusal(), HasSubstr("its checksum does not fit"));
}

}  // namespace
}  // namespace throng::pack::sections_test
