#pragma once

#include <filesystem>

#include <gtest/gtest.h>

#include "tests/own_folder.h"

namespace throng::app::test {

/// Gives each of its tests a folder of its own.
class TemporaryFolder : public testing::Test {
 private:
  const throng::test::OwnFolder own_;

 protected:
  const std::filesystem::path& folder_ = own_.path();
};

}  // namespace throng::app::test
