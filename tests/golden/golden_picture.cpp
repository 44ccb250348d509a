#include "tests/golden/golden_picture.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "app/demo/demo.h"
#include "tests/render/image_difference.h"

namespace throng::app::test {
namespace {

constexpr std::uintmax_t largest_picture_bytes = 200'000;  // a plaza has the most corners

std::filesystem::path golden_file(const std::string& name) {
  return std::filesystem::path(THRONG_SOURCE_DIR) / "tests" / "golden" / "pictures" / (name + ".png");
}

std::filesystem::path output_file(const std::string& name, const char* what) {
  return std::filesystem::temp_directory_path() / ("throng-golden-" + name + "-" + what + ".png");
}

// Six bits a channel keep a golden picture below its bytes; what is compared with it is rounded alike.
render::Image rounded_to_six_bits(render::Image image) {
  for (std::uint8_t& value : image.rgba) {
    if (value != 255) value = static_cast<std::uint8_t>(value & 0xFCU);
  }
  return image;
}

// The driver that drew is part of the promise: a graphics card draws another picture.
void expect_software_device(const std::filesystem::path& stats) {
  std::ifstream stream(stats);
  const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  EXPECT_NE(text.find("llvmpipe"), std::string::npos) << text;
}

void write_failure(const std::string& name, const render::Image& expected, const render::Image& actual,
                   const render::Image& difference) {
  EXPECT_TRUE(render::write_png(expected, output_file(name, "expected")));
  EXPECT_TRUE(render::write_png(actual, output_file(name, "actual")));
  EXPECT_TRUE(render::write_png(difference, output_file(name, "difference")));
}

}  // namespace

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

void look_at_plain_sky(DemoOptions& options) {
  options.camera = CameraPlace{.y = 2, .z = 5, .pitch = 35};
  options.tuning.light.clouds = 0.0F;
  options.tuning.scenery = false;
}

void expect_golden_picture(const std::string& name, const DemoOptions& golden) {
  DemoOptions options = golden;
  const std::string run = name + (options.context == ContextKind::osmesa ? "-osmesa" : "-egl");
  options.screenshot = output_file(run, "actual").string();
  options.stats = output_file(run, "stats").string() + ".json";
  ASSERT_EQ(run_demo(options), 0);
  expect_software_device(options.stats);
  const auto drawn = render::read_png(options.screenshot);
  ASSERT_TRUE(drawn) << drawn.error().message;
  expect_golden_image(name, run, *drawn);
}

void expect_golden_image(const std::string& name, const std::string& run, const render::Image& drawn) {
  const render::Image actual = rounded_to_six_bits(drawn);
  if (std::getenv("THRONG_UPDATE_GOLDEN") != nullptr) {
    ASSERT_TRUE(render::write_png(actual, golden_file(name)));
  }
  const auto expected = render::read_png(golden_file(name));
  ASSERT_TRUE(expected) << expected.error().message;
  EXPECT_LE(std::filesystem::file_size(golden_file(name)), largest_picture_bytes);
  const auto difference = render::test::compare(*expected, actual);
  ASSERT_TRUE(difference) << difference.error().message;
  const bool same = difference->mean <= largest_mean_difference && difference->worst_block <= largest_block_difference;
  EXPECT_TRUE(same) << name << ": mean " << difference->mean << ", worst block " << difference->worst_block << " at "
                    << difference->worst_block_x << ", " << difference->worst_block_y << "; see "
                    << output_file(run, "difference");
  if (!same) write_failure(run, *expected, actual, difference->picture);
}

}  // namespace throng::app::test
