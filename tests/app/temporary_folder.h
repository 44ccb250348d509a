#pragma once

#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace throng::app::test {

/// Returns a path where no other test writes, though all may run at once.
inline std::filesystem::path path_of_this_test() {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string("throng_") + test.test_suite_name() + "." + test.name();
  std::ranges::replace(name, '/', '_');
  return std::filesystem::path(testing::TempDir()) / name;
}

/// A folder of the test's own, empty before it and gone after it.
class TemporaryFolder : public testing::Test {
 protected:
  TemporaryFolder() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~TemporaryFolder() override { std::filesystem::remove_all(folder_); }

  const std::filesystem::path folder_ = path_of_this_test();
};

}  // namespace throng::app::test
