#include "app/files/json_file.h"

#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/own_folder.h"

namespace throng::app::json_file_test {
namespace {

TEST(JsonFile, BeginsComplaintsWithItsNameAndEndsThemWithARemedy) {
  const throng::test::OwnFolder folder;
  const std::string path = folder.path() / "file.json";
  const JsonFile file(path, {.unread = "look", .malformed = "mend", .wrong = "change"});
  EXPECT_EQ(file.read().error().message, path + ": there is no such file; check the path; look");
  std::ofstream(path) << "[";
  EXPECT_EQ(file.read().error().message, path + ": is not JSON at line 1, column 2; mend");
  EXPECT_EQ(JsonFile(path).read().error().message, path + ": is not JSON at line 1, column 2; mend it there");
  std::ofstream(path) << "[7]";
  EXPECT_EQ(*file.read(), Json::array({7}));
  EXPECT_EQ(file.wrong("has a hole").message, path + ": has a hole; change");
}

}  // namespace
}  // namespace throng::app::json_file_test
