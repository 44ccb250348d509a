// Numbers that clips have over time.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "tests/anim/agent/heard_misuses.h"
#include "tests/api/api_crowd.h"

namespace throng::curves_test {
namespace {

/// A character whose first clip glows more and more for half a second.
Character glowing() {
  std::ifstream plain(THRONG_SOURCE_DIR "/tests/data/features/data-uri.gltf");
  std::string text((std::istreambuf_iterator<char>(plain)), std::istreambuf_iterator<char>());
  const std::string animation = "\"animations\":[{";
  text.insert(text.find(animation) + animation.size(),
              R"("extras":{"curves":{"glow":{"times":[0,0.5],"values":[0,2]}}},)");
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "throng_glowing.gltf";
  std::ofstream(path) << text;
  const auto loaded = load(path.string());
  EXPECT_TRUE(loaded);
  std::filesystem::remove(path);
  return loaded->characters.front();
}

TEST(ApiCurves, AreReadByTheIndexOfTheirName) {
  const Character character = glowing();
  ASSERT_EQ(character.curve_names().size(), 1U);
  EXPECT_EQ(character.curve_names()[0], "glow");
  auto crowd = Crowd::create(character);
  ASSERT_TRUE(crowd);
  const Agent agent = crowd->agent(crowd->add_agent());
  ASSERT_TRUE(agent.play({.clip = {0}, .loop = false}));
  EXPECT_EQ(agent.motion().curve(0), 0.0F);
  crowd->advance(ticks_per_second / 4);
  EXPECT_NEAR(agent.motion().curve(0), 1.0F, 1e-3F);
}

TEST(ApiCurves, OfNoNameAreAMisuse) {
  const anim::HeardMisuses heard;
  api_test::ApiCrowd crowd(1);
  EXPECT_EQ(crowd.agent(0).motion().curve(0), 0.0F) << "the mannequin has none";
  EXPECT_EQ(crowd.agent(7).motion().curve(0), 0.0F) << "and this agent is not there";
  EXPECT_EQ(heard.all().size(), 2U);
}

}  // namespace
}  // namespace throng::curves_test
