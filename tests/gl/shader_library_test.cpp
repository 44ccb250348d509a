#include "engine/render/shader/shader_library.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/gl/gl_test.h"

namespace throng::render::test::shader_library_test {
namespace {

class ShaderLibraryFolder : public SoftwareGlTest {
 protected:
  ShaderLibraryFolder() {
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("throng_library_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
    write("any.vert", "#version 450 core\nvoid main() { gl_Position = vec4(0.0); }\n");
    write("good.frag", "#version 450 core\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n");
  }
  void TearDown() override {
    // The driver reports the intended mistakes too, in its own words.
    context().messages().clear();
    SoftwareGlTest::TearDown();
  }
  ~ShaderLibraryFolder() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

  std::filesystem::path folder_;
};

TEST_F(ShaderLibraryFolder, NamesFileAndLineOfAMistakeInAnIncludedFile) {
  write("light.glsl", "float sun() {\n  return moon;\n}\n");
  write("bad.frag",
        "#version 450 core\nout vec4 color;\n#include \"light.glsl\"\nvoid main() { color = vec4(sun()); }\n");
  ShaderLibrary shaders(folder_);
  shaders.load({"any.vert", "bad.frag"});
  ASSERT_FALSE(shaders.status());
  EXPECT_NE(shaders.status().error().message.find("light.glsl:2: "), std::string::npos)
      << shaders.status().error().message;
  EXPECT_EQ(shaders.status().error().message.find('\n'), std::string::npos);
}

TEST_F(ShaderLibraryFolder, SaysInOneSentenceWhatDoesNotLink) {
  write("lonely.frag",
        "#version 450 core\nin vec3 nowhere;\nout vec4 color;\nvoid main() { color = vec4(nowhere, 1.0); }\n");
  ShaderLibrary shaders(folder_);
  shaders.load({"any.vert", "lonely.frag"});
  ASSERT_FALSE(shaders.status());
  EXPECT_NE(shaders.status().error().message.find("lonely.frag"), std::string::npos);
  EXPECT_EQ(shaders.status().error().message.find('\n'), std::string::npos);
}

TEST_F(ShaderLibraryFolder, IsOutOfDateOnceAFileIsSavedUntilItIsBuiltAgain) {
  ShaderLibrary shaders(folder_);
  shaders.load({"any.vert", "good.frag"});
  EXPECT_FALSE(shaders.is_out_of_date());
  const auto later = std::filesystem::last_write_time(folder_ / "good.frag") + std::chrono::seconds(2);
  std::filesystem::last_write_time(folder_ / "good.frag", later);
  EXPECT_TRUE(shaders.is_out_of_date());
  EXPECT_TRUE(shaders.reload());
  EXPECT_FALSE(shaders.is_out_of_date());
  write("new.glsl", "");
  EXPECT_TRUE(shaders.is_out_of_date());
  EXPECT_TRUE(shaders.reload());
  std::filesystem::remove_all(folder_);
  EXPECT_TRUE(shaders.is_out_of_date());
}

TEST_F(ShaderLibraryFolder, KeepsTheLastGoodProgramWhenAReloadFails) {
  ShaderLibrary shaders(folder_);
  const gl::Program& program = shaders.load({"any.vert", "good.frag"});
  ASSERT_TRUE(shaders.status()) << shaders.status().error().message;
  const auto good = program.id();
  write("good.frag", "#version 450 core\nnonsense\n");
  EXPECT_FALSE(shaders.reload());
  EXPECT_EQ(program.id(), good);
  write("good.frag", "#version 450 core\nout vec4 color;\nvoid main() { color = vec4(0.5); }\n");
  EXPECT_TRUE(shaders.reload());
  EXPECT_NE(program.id(), good);
}

TEST_F(ShaderLibraryFolder, NamesTheFolderThatHasNoShaders) {
  ShaderLibrary shaders(folder_ / "absent");
  shaders.load({"any.vert", "good.frag"});
  ASSERT_FALSE(shaders.status());
  EXPECT_NE(shaders.status().error().message.find("absent/any.vert"), std::string::npos);
}

}  // namespace
}  // namespace throng::render::test::shader_library_test
