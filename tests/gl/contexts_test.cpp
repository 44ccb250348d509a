#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "throng/render/context.h"
#include "throng/render/image.h"

#include "tests/gl/doll_crowd.h"
#include "tests/gl/picture_tolerance.h"

namespace throng::render::test::contexts_test {
namespace {

using MakeContext = std::function<Result<std::unique_ptr<gl::Context>>()>;

const MakeContext egl = [] { return gl::make_egl_context({.force_software = true}); };
const MakeContext osmesa = [] { return gl::make_osmesa_context(); };

constexpr std::size_t crowd_size = 15;

/// Returns 0 if the picture was drawn and written, and the driver sent no message.
int draw_picture(const MakeContext& make_context, int samples, const std::filesystem::path& file) {
  Result<std::unique_ptr<gl::Context>> context = make_context();
  if (!context) return 1;
  DollCrowd crowd(**context, samples);
  crowd.stand(crowd_size);
  crowd.write_palettes();
  const Status written = write_png(crowd.picture(), file);
  return written && (*context)->messages().count() == 0 ? 0 : 1;
}

/// Runs in a process of its own, because a process makes only one context.
void draw_picture_apart(const MakeContext& make_context, int samples, const std::filesystem::path& file) {
  const pid_t child = fork();
  if (child == 0) _exit(draw_picture(make_context, samples, file));
  int status = -1;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  ASSERT_EQ(WEXITSTATUS(status), 0);
}

/// Returns samples for tests that need OSMesa; none on a machine without it.
std::vector<int> with_osmesa(std::vector<int> samples) {
  return gl::osmesa_is_installed() ? samples : std::vector<int>();
}

class ContextPair : public testing::TestWithParam<int> {};
class OsMesaContext : public testing::TestWithParam<int> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ContextPair);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(OsMesaContext);

TEST_P(ContextPair, DrawsTheSameThroughEglAndOsMesaWithoutComplaint) {
  const std::filesystem::path folder = testing::TempDir();
  const std::string suffix = std::to_string(GetParam()) + ".png";
  draw_picture_apart(egl, GetParam(), folder / ("throng_egl_" + suffix));
  draw_picture_apart(osmesa, GetParam(), folder / ("throng_osmesa_" + suffix));
  const Result<Image> through_egl = read_png(folder / ("throng_egl_" + suffix));
  const Result<Image> through_osmesa = read_png(folder / ("throng_osmesa_" + suffix));
  ASSERT_TRUE(through_egl);
  ASSERT_TRUE(through_osmesa);
  const Result<PictureDifference> difference = measure_difference(*through_egl, *through_osmesa);
  ASSERT_TRUE(difference);
  EXPECT_TRUE(looks_the_same(*difference)) << difference->mean << ' ' << difference->worst_block;
}

INSTANTIATE_TEST_SUITE_P(Samples, ContextPair, testing::ValuesIn(with_osmesa({0, 4})));
INSTANTIATE_TEST_SUITE_P(Only, OsMesaContext, testing::ValuesIn(with_osmesa({0})));

TEST(EglContext, OfTheSoftwareDeviceIsAtLeastFourFiveCore) {
  const Result<std::unique_ptr<gl::Context>> context = egl();
  ASSERT_TRUE(context) << context.error().message;
  EXPECT_STREQ((*context)->kind(), "egl");
  EXPECT_THAT((*context)->version().substr(0, 3), ::testing::AnyOf("4.5", "4.6"));
  EXPECT_TRUE((*context)->is_software());
  EXPECT_EQ((*context)->window(), nullptr);
}

TEST(EglContext, TakesTheSoftwareDeviceWhereMesasVariableAsksForItAndLeavesTheVariable) {
  setenv("LIBGL_ALWAYS_SOFTWARE", "true", 1);
  const Result<std::unique_ptr<gl::Context>> context = gl::make_egl_context({});
  ASSERT_TRUE(context) << context.error().message;
  EXPECT_TRUE((*context)->is_software());
  EXPECT_NE(std::getenv("LIBGL_ALWAYS_SOFTWARE"), nullptr);
  unsetenv("LIBGL_ALWAYS_SOFTWARE");
}

TEST_P(OsMesaContext, IsFourFiveCore) {
  const Result<std::unique_ptr<gl::Context>> context = osmesa();
  ASSERT_TRUE(context) << context.error().message;
  EXPECT_STREQ((*context)->kind(), "osmesa");
  EXPECT_EQ((*context)->version().substr(0, 3), "4.5");
  EXPECT_TRUE((*context)->is_software());
}

TEST(WindowContext, WithoutADisplaySaysSoInOneLine) {
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  const Result<std::unique_ptr<gl::Context>> context = gl::make_window_context({});
  ASSERT_FALSE(context);
  EXPECT_EQ(context.error().message.find("no display to open a window on ("), 0U) << context.error().message;
  EXPECT_EQ(context.error().message.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace throng::render::test::contexts_test
