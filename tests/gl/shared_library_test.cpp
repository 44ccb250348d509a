#include "engine/render/gl/shared_library.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace throng::render::test::shared_library_test {
namespace {

TEST(SharedLibrary, ThatIsNotInstalledNamesItsPackage) {
  const auto library = gl::open_library("libthrong_nowhere.so.1", "libthrong1");
  ASSERT_FALSE(library);
  EXPECT_EQ(library.error().message, "libthrong_nowhere.so.1 is not installed, install libthrong1");
}

TEST(SharedLibrary, ThatIsBrokenSaysWhy) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "libthrong_broken.so.1";
  std::ofstream(file) << "no library";
  const auto library = gl::open_library(file.c_str(), "libthrong1");
  std::filesystem::remove(file);
  ASSERT_FALSE(library);
  EXPECT_NE(library.error().message.find(" is installed and cannot be loaded ("), std::string::npos);
  EXPECT_NE(library.error().message.find("file too short"), std::string::npos) << library.error().message;
}

TEST(SharedLibrary, HasFunctionsByName) {
  const auto library = gl::open_library("libm.so.6", "libc6");
  ASSERT_TRUE(library) << library.error().message;
  double (*cosine)(double) = nullptr;
  gl::find_function(*library, cosine, "cos");
  ASSERT_NE(cosine, nullptr);
  EXPECT_EQ(cosine(0.0), 1.0);
  gl::find_function(*library, cosine, "throng_has_no_such_function");
  EXPECT_EQ(cosine, nullptr);
}

}  // namespace
}  // namespace throng::render::test::shared_library_test
