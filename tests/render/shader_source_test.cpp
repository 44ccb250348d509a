#include "engine/render/shader/shader_source.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace throng::render::shader_source_test {
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

TEST_F(ShaderFolder, PutsAnIncludedFileInPlaceOnce) {
  write("light.glsl", "light\n");
  write("crowd.glsl", "#include \"light.glsl\"\ncrowd\n");
  write("main.vert", "#version 450 core\n#include \"light.glsl\"\n#include \"crowd.glsl\"\nmain\n");
  const Result<ShaderSource> source = read_shader_source(folder_, "main.vert");
  ASSERT_TRUE(source);
  EXPECT_EQ(source->files, (std::vector<std::string>{"main.vert", "light.glsl", "crowd.glsl"}));
  EXPECT_EQ(source->text, "#version 450 core\nlight\ncrowd\nmain\n");
}

TEST_F(ShaderFolder, NamesTheFileThatIsMissing) {
  write("main.vert", "#include \"absent.glsl\"\n");
  const Result<ShaderSource> source = read_shader_source(folder_, "main.vert");
  ASSERT_FALSE(source);
  EXPECT_NE(source.error().message.find("absent.glsl"), std::string::npos);
}

TEST_F(ShaderFolder, TakesAComplaintOfAnyDriverBackToFileAndLineAsWritten) {
  write("light.glsl", "light\nmoon\n");
  write("main.vert", "#version 450 core\n#include \"light.glsl\"\nmain\n");
  const Result<ShaderSource> source = read_shader_source(folder_, "main.vert");
  ASSERT_TRUE(source);
  EXPECT_EQ(first_complaint("0:3(5): error: `moon' undeclared\n0:4(1): error: more", *source),
            "light.glsl:2: error: `moon' undeclared");
  EXPECT_EQ(first_complaint("0(4) : error C1008: undefined variable", *source),
            "main.vert:3: error C1008: undefined variable");
}

TEST_F(ShaderFolder, KeepsAComplaintThatNamesNoLineOfIt) {
  write("main.vert", "#version 450 core\n");
  const Result<ShaderSource> source = read_shader_source(folder_, "main.vert");
  ASSERT_TRUE(source);
  EXPECT_EQ(first_complaint("out of memory\n", *source), "main.vert: out of memory");
  EXPECT_EQ(first_complaint("0:77(1): error: end\n", *source), "main.vert: 0:77(1): error: end");
}

}  // namespace
}  // namespace throng::render::shader_source_test
