#pragma once

#include <filesystem>

#include <gtest/gtest.h>

namespace throng::app::test {

/// A folder of the test's own, empty before it and gone after it.
class TemporaryFolder : public testing::Test {
 protected:
  TemporaryFolder() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~TemporaryFolder() override { std::filesystem::remove_all(folder_); }

  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
};

}  // namespace throng::app::test
