#include <filesystem>
#include <fstream>
#include <string>

#include "tests/window/window_driver.h"

namespace throng::app::model_drop_test {
namespace {

using Json = nlohmann::json;
using DroppedModel = WindowDriver;

std::string message_of(const Json& map) { return map["report"]["message"]; }

TEST_F(DroppedModel, ReplacesTheCharacterAndTheCrowdGoesOn) {
  const std::string model = std::string(THRONG_SOURCE_DIR) + "/tests/data/features/plain.glb";
  drop(model);
  const Json map = wait_for("the new character", [&](const Json& now) {
    return now["report"]["characters"] == Json::array({model}) && now["report"]["drawn"] > 0;
  });
  EXPECT_EQ(map["report"]["agents"], 50);
  next_map(5);
}

TEST_F(DroppedModel, MayBeAFolderWhoseSharesAreDragged) {
  drop(folder_of_models({"a.glb", "b.glb"}));
  const Json map = wait_for("both characters", [](const Json& now) {
    return now["report"]["cast"].size() == 2 && now["report"]["drawn"] > 0;
  });
  EXPECT_EQ(map["report"]["cast"][1]["agents"], 25);
  drag("b.glb", 0.0);
  wait_for("no agent of the smallest share", [](const Json& now) {
    return now["report"]["cast"][1]["agents"] == 0 && now["report"]["cast"][0]["agents"] == 50;
  });
}

TEST_F(DroppedModel, WithoutAMeshLendsItsClipsWhichAreUnsavedUntilThatIsTakenBack) {
  const std::string features = std::string(THRONG_SOURCE_DIR) + "/tests/data/features/";
  std::ifstream stream(features + "data-uri.gltf");
  Json clips = Json::parse(stream);
  for (const char* const key : {"meshes", "skins", "materials"}) clips.erase(key);
  for (Json& node : clips["nodes"]) {
    node.erase("mesh");
    node.erase("skin");
  }
  std::ofstream(folder() / "moves.gltf") << clips.dump();
  const auto wait_for_notice = [&](const std::string& what, bool is_there) {
    wait_for(what, [&](const Json& now) {
      return (now["report"]["notice"].get<std::string>().find("moves.gltf: 1 clip taken") != std::string::npos) ==
             is_there;
    });
  };
  const std::string still = features + "no-animation.glb";
  drop(still);
  wait_for("the character", [&](const Json& now) {
    return now["report"]["characters"] == Json::array({still}) && now["report"]["drawn"] > 0;
  });
  drop((folder() / "moves.gltf").string());
  wait_for_message("The clips of moves.gltf are lent to no-animation");
  wait_for_notice("the clips", true);
  xdotool({"key", "ctrl+q"});
  wait_for("a question about the clips", [](const Json& now) { return now["widgets"].contains("unsaved:save"); });
  xdotool({"key", "Escape"});
  wait_for("no question", [](const Json& now) { return !now["widgets"].contains("unsaved:save"); });
  xdotool({"key", "ctrl+z"});
  wait_for_notice("the clips to be gone", false);
}

TEST_F(DroppedModel, ABadOneChangesNothingAndSaysWhy) {
  const Json before = next_map()["report"]["characters"];
  const std::string bad = std::string(THRONG_SOURCE_DIR) + "/README.md";
  drop(bad);
  const Json map =
      wait_for("a refusal", [&](const Json& now) { return message_of(now).find(bad) != std::string::npos; });
  EXPECT_EQ(map["report"]["characters"], before);
  const Json later = next_map(5);
  EXPECT_EQ(later["report"]["agents"], 50);
  EXPECT_GT(later["report"]["drawn"], 0);
}

}  // namespace
}  // namespace throng::app::model_drop_test
