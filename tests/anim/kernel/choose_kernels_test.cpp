// A SIMD target is found by its name, and one that is chosen runs all that names none.
#include "engine/anim/kernel/choose_kernels.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/kernel/kernels.h"
#include "tests/anim/agent/crowd_rig.h"
#include "tests/anim/agent/hashed_crowds.h"

namespace throng::anim::choose_kernels_test {
namespace {

std::string lower(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

TEST(FindKernels, FindsEachTargetOfThisMachineByItsNameInAnyCase) {
  const std::vector<std::string> names = runnable_targets();
  ASSERT_EQ(names.size(), runnable_kernels().size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(names[i], runnable_kernels()[i].target);
    EXPECT_EQ(find_kernels(names[i]), &runnable_kernels()[i]);
    EXPECT_EQ(find_kernels(lower(names[i])), &runnable_kernels()[i]);
  }
}

TEST(FindKernels, TakesAvx512ForTheBestOfItsKind) {
  const Kernels* const found = find_kernels("avx512");
  const auto is_avx512 = [](const std::string& name) { return name.starts_with("AVX3"); };
  const std::vector<std::string> names = runnable_targets();
  const auto first = std::ranges::find_if(names, is_avx512);
  ASSERT_EQ(found == nullptr, first == names.end());
  if (found != nullptr) {
    EXPECT_EQ(found->target, *first);
  }
}

TEST(FindKernels, FindsNothingElse) {
  for (const char* const name : {"", "AVX", "AVX22", "avx5120", "best", "AVX2 "}) {
    EXPECT_EQ(find_kernels(name), nullptr) << name;
  }
}

class ChooseKernels : public testing::Test {
 protected:
  ~ChooseKernels() override { choose_kernels(runnable_kernels().front()); }
};

TEST_F(ChooseKernels, PosesEveryCrowdOnTheTargetThatIsChosen) {
  for (const Kernels& kernels : runnable_kernels()) {
    choose_kernels(kernels);
    EXPECT_EQ(&best_kernels(), &kernels);
    const auto crowd = AnimationSystem::create(test_character(), {});
    ASSERT_TRUE(crowd);
    EXPECT_STREQ((*crowd)->figures().kernels().target, kernels.target);
    const HashedCrowd& fading = hashed_crowds().front();
    EXPECT_EQ(fading.hash_of({}), fading.hash_of({.kernels = &kernels})) << kernels.target;
  }
}

TEST_F(ChooseKernels, LeavesACrowdThatNamesItsKernelsThose) {
  choose_kernels(scalar_kernels());
  const auto crowd = AnimationSystem::create(test_character(), {.kernels = &runnable_kernels().front()});
  ASSERT_TRUE(crowd);
  EXPECT_EQ(&(*crowd)->figures().kernels(), &runnable_kernels().front());
}

}  // namespace
}  // namespace throng::anim::choose_kernels_test
