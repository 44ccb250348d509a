#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/import/import.h"
#include "tests/import/test_files.h"

// Damage at random, the same on every run: import answers or refuses, and never harms. Worth most under asan and ubsan.

namespace throng::import::testing::fuzz_test {
namespace {

constexpr int rounds = 150;

void expect_an_answer(const std::filesystem::path& path) {
  const auto file = import_file(path.string());
  if (file) {
    EXPECT_FALSE(file->models.empty());
  } else {
    EXPECT_THAT(file.error().message, ::testing::StartsWith(path.string() + ": "));
  }
}

class Damaged : public ::testing::TestWithParam<std::string> {
 protected:
  std::vector<char> whole_ = read_bytes(data_path("features/" + GetParam()));
  std::mt19937 random_{12345};
  TemporaryFolder folder_;

  std::size_t any_place() { return random_() % whole_.size(); }
};

TEST_P(Damaged, BytesAreNoHarm) {
  for (int round = 0; round < rounds; ++round) {
    std::vector<char> bytes = whole_;
    const auto damages = 1 + random_() % 8;
    for (unsigned damage = 0; damage < damages; ++damage) bytes[any_place()] = static_cast<char>(random_());
    expect_an_answer(folder_.write("damaged.glb", bytes));
  }
}

TEST_P(Damaged, EndsAreNoHarm) {
  for (int round = 0; round < rounds / 3; ++round) {
    std::vector<char> bytes = whole_;
    bytes.resize(any_place());
    expect_an_answer(folder_.write("damaged.glb", bytes));
  }
}

TEST_P(Damaged, NumbersAreNoHarm) {
  for (int round = 0; round < rounds; ++round) {
    std::vector<char> bytes = whole_;
    auto place = std::find_if(bytes.begin() + static_cast<std::ptrdiff_t>(any_place()), bytes.end(),
                              [](char c) { return c >= '0' && c <= '9'; });
    if (place != bytes.end()) *place = static_cast<char>('0' + random_() % 10);
    expect_an_answer(folder_.write("damaged.glb", bytes));
  }
}

INSTANTIATE_TEST_SUITE_P(Files, Damaged,
                         ::testing::Values("interleaved.glb", "sparse-output.glb", "data-uri.gltf", "weights-u8.glb"),
                         [](const auto& instance) { return as_test_name(instance.param); });

}  // namespace
}  // namespace throng::import::testing::fuzz_test
