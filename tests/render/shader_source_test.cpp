#include "engine/render/shader_source.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace throng::render {
namespace {

class ShaderFolder : public testing::Test {
 protected:
  ShaderFolder() {
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("throng_shader_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
  }
  ~ShaderFolder() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

  std::filesystem::path folder_;
};

TEST_F(ShaderFolder, PutsAnIncludedFileInPlaceOnceAndNumbersLines) {
  write("light.glsl", "light\n");
  write("crowd.glsl", "#include \"light.glsl\"\ncrowd\n");
  write("main.vert", "#version 450 core\n#include \"light.glsl\"\n#include \"crowd.glsl\"\nmain\n");
  const Result<ShaderSource> source = read_shader_source(folder_, "main.vert");
  ASSERT_TRUE(source);
  EXPECT_EQ(source->files, (std::vector<std::string>{"main.vert", "light.glsl", "crowd.glsl"}));
  EXPECT_EQ(source->text,
            "#version 450 core\n"
            "#line 1 1\nlight\n#line 3 0\n"
            "#line 1 2\n#line 2 2\ncrowd\n#line 4 0\n"
            "main\n");
}

TEST_F(ShaderFolder, NamesTheFileThatIsMissing) {
  write("main.vert", "#include \"absent.glsl\"\n");
  const Result<ShaderSource> source = read_shader_source(folder_, "main.vert");
  ASSERT_FALSE(source);
  EXPECT_NE(source.error().message.find("absent.glsl"), std::string::npos);
}

TEST(ShaderComplaint, NamesFileAndLineAsWrittenByEveryDriver) {
  const ShaderSource source{"", {"main.vert", "light.glsl"}};
  EXPECT_EQ(first_complaint("1:12(5): error: `sun' undeclared\n1:13(1): error: more", source),
            "light.glsl:12: error: `sun' undeclared");
  EXPECT_EQ(first_complaint("0(7) : error C1008: undefined variable", source),
            "main.vert:7: error C1008: undefined variable");
}

TEST(ShaderComplaint, KeepsWhatItCannotRead) {
  EXPECT_EQ(first_complaint("out of memory\n", {"", {"main.vert"}}), "main.vert: out of memory");
}

}  // namespace
}  // namespace throng::render
