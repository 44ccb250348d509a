#include "tests/golden/golden_picture.h"

#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "throng/render/context.h"

#include "app/output/regression/compare.h"
#include "app/window/demo.h"

namespace throng::app::test {
namespace {

namespace fs = std::filesystem;

fs::path golden_file(const std::string& name) { return golden_cases().pictures / (name + ".png"); }

fs::path output_file(const std::string& name, const char* what) {
  return fs::temp_directory_path() / ("throng-golden-" + name + "-" + what + ".png");
}

bool same_pixels(const render::Image& a, const render::Image& b) { return a.width == b.width && a.rgba == b.rgba; }

// A picture that is the same keeps its bytes.
void replace(const fs::path& file, const render::Image& picture, const PictureOrigin& origin) {
  const auto before = render::read_png(file);
  if (before && same_pixels(*before, picture)) return;
  ASSERT_TRUE(render::write_png(picture, file, texts_of(origin)));
}

void write_failure(const std::string& name, const render::Image& expected, const render::Image& actual) {
  EXPECT_TRUE(render::write_png(expected, output_file(name, "expected")));
  EXPECT_TRUE(render::write_png(actual, output_file(name, "actual")));
  EXPECT_TRUE(render::write_png(paint_difference(expected, actual), output_file(name, "difference")));
}

}  // namespace

const RegressionCases& golden_cases() {
  static const auto cases = read_cases(THRONG_SOURCE_DIR "/tests/golden/cases.json");
  if (!cases) ADD_FAILURE() << cases.error().message;
  return *cases;
}

std::vector<ContextKind> golden_contexts() {
  if (!render::gl::osmesa_is_installed()) return {ContextKind::egl};
  return {ContextKind::egl, ContextKind::osmesa};
}

DemoOptions golden_options(ContextKind context) {
  DemoOptions options;
  options.context = context;
  options.force_software = true;
  options.width = 640;
  options.height = 360;
  options.frames = 8;
  options.tuning.agents = 40;
  options.tuning.system.pus = 2;
  options.data = THRONG_SOURCE_DIR;
  return options;
}

void expect_golden_picture(const std::string& name, const DemoOptions& golden) {
  DemoOptions options = golden;
  const std::string run = name + (options.context == ContextKind::osmesa ? "-osmesa" : "-egl");
  options.screenshot = output_file(run, "actual").string();
  ASSERT_EQ(run_demo(options), 0);
  const auto drawn = render::read_png(options.screenshot);
  ASSERT_TRUE(drawn) << drawn.error().message;
  const PictureOrigin origin = read_origin(options.screenshot);
  EXPECT_NE(origin.renderer.find("llvmpipe"), std::string::npos) << "a graphics card draws another picture";
  expect_golden_image(name, run, *drawn, origin);
}

void expect_golden_image(const std::string& name, const std::string& run, const render::Image& drawn,
                         const PictureOrigin& origin) {
  const render::Image actual = rounded_to_bits(drawn, golden_cases().bits);
  if (std::getenv("THRONG_UPDATE_GOLDEN") != nullptr) replace(golden_file(name), actual, origin);
  const auto expected = render::read_png(golden_file(name));
  ASSERT_TRUE(expected) << expected.error().message;
  const auto difference = measure_difference(*expected, actual);
  ASSERT_TRUE(difference) << difference.error().message;
  const auto figures = judge(*difference, golden_cases().tolerance);
  EXPECT_TRUE(all_within(figures)) << name << ": " << other_origin(read_origin(golden_file(name)), origin) << "; "
                                   << excess_text(figures) << "; see " << output_file(run, "difference");
  if (!all_within(figures)) write_failure(run, *expected, actual);
}

}  // namespace throng::app::test
