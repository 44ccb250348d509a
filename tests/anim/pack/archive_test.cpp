#include "engine/anim/pack/archive.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::pack {

namespace archive_test {
struct Pair {
  int number = 0;
  std::string name;
  friend bool operator==(const Pair&, const Pair&) = default;
};
struct Wider {
  std::int64_t number = 0;
  std::string name;
};
}  // namespace archive_test

template <typename Archive, Same<archive_test::Pair> T>
void describe(Archive& archive, T& pair) {
  archive(pair.number, pair.name);
}
template <typename Archive, Same<archive_test::Wider> T>
void describe(Archive& archive, T& wider) {
  archive(wider.number, wider.name);
}

namespace archive_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

template <typename... Values>
std::vector<std::byte> written(const Values&... values) {
  PackWriter writer;
  writer(values...);
  return writer.bytes();
}

template <typename Value>
std::uint64_t layout_of() {
  PackLayout layout;
  layout(Value{});
  return layout.hash();
}

TEST(PackArchive, ReadsBackWhatItWrote) {
  const std::vector<Pair> pairs{{1, "one"}, {-2, ""}};
  const std::optional<double> some = 2.5, none;
  const std::vector<std::byte> bytes = written(pairs, some, none, true, std::string("end"));
  PackReader reader(bytes, nullptr);
  std::vector<Pair> read;
  std::optional<double> first, second = 1.0;
  bool flag = false;
  std::string end;
  reader(read, first, second, flag, end);
  EXPECT_TRUE(reader.read_all());
  EXPECT_EQ(read, pairs);
  EXPECT_EQ(first, some);
  EXPECT_EQ(second, none);
  EXPECT_TRUE(flag);
  EXPECT_EQ(end, "end");
}

TEST(PackArchive, FailsWhereBytesEndOrAreLeft) {
  const std::vector<std::byte> bytes = written(std::vector<Pair>{{1, "one"}, {2, "two"}});
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    PackReader reader(std::span{bytes}.first(size), nullptr);
    std::vector<Pair> read;
    reader(read);
    EXPECT_FALSE(reader.read_all()) << size;
  }
  std::vector<std::byte> longer = bytes;
  longer.push_back({});
  PackReader reader(longer, nullptr);
  std::vector<Pair> read;
  reader(read);
  EXPECT_FALSE(reader.read_all());
}

TEST(PackArchive, TakesNoMemoryForACountThatItsBytesCannotHold) {
  const std::vector<std::byte> bytes = written(std::uint64_t{1} << 60U);
  std::vector<double> numbers;
  PackReader reader(bytes, nullptr);
  reader(numbers);
  EXPECT_FALSE(reader.read_all());
  EXPECT_THAT(numbers, IsEmpty());
}

TEST(PackLayout, ChangesWithEveryMember) {
  EXPECT_EQ(layout_of<Pair>(), layout_of<Pair>());
  EXPECT_NE(layout_of<Pair>(), layout_of<Wider>());
  EXPECT_NE(layout_of<std::vector<Pair>>(), layout_of<Pair>());
  EXPECT_NE(layout_of<std::vector<float>>(), layout_of<std::vector<int>>());
}

}  // namespace
}  // namespace archive_test
}  // namespace throng::pack
