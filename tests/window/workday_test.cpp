// A technical artist's day with the program, from the first look at a model to the crowd that is kept, at three desks.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/shell_words.h"
#include "tests/window/scaled_model.h"
#include "tests/window/window_driver.h"

namespace throng::app::workday_test {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

/// The pixels of a screen, and the size of what is written on it.
struct Desk {
  glm::ivec2 screen;
  std::string scale;
};

std::string size_words(glm::ivec2 size) { return std::to_string(size.x) + "x" + std::to_string(size.y); }

Json json_of(const fs::path& file) { return Json::parse(std::ifstream(file), nullptr, false); }

class Workday : public WindowDriver, public testing::WithParamInterface<Desk> {
 protected:
  static constexpr int frames = 30;

  /// The picture keeps its cost, and no limit of triangles adds to the error.
  std::vector<std::string> options() const override {
    return {"--agents",   "40",
            "--size",     size_words(GetParam().screen),
            "--ui-scale", GetParam().scale,
            "--set",      "holds_rate=off,triangle_budget=0"};
  }
  glm::ivec2 screen() const override { return GetParam().screen; }

  void open_a_model(const std::string& name, double times) {
    const std::string file = (folder() / name).string();
    write_scaled_mannequin(file, times);
    drop(file);
    wait_for(name, [&](const Json& map) {
      return map["report"]["characters"] == Json::array({file}) && map["report"]["drawn"] > 0;
    });
  }
  void give_a_clip_to_a_role_after_a_look(const std::string& role, const std::string& clip) {
    open_tab("Crowd");
    click_in_tab(role);
    click(role + ":" + clip);
    wait_for("the viewer with " + clip, [&](const Json& map) {
      return map["report"]["viewer"].is_object() && map["report"]["viewer"]["clip"] == clip &&
             map["report"]["viewer"]["seconds"] > 0;
    });
    click("Apply to the crowd");
    wait_for("the crowd", [](const Json& map) { return map["report"]["viewer"].is_null(); });
  }
  void look_at_it_alone() {
    open_tab("Crowd");
    click_in_tab("View model");
    wait_for("the viewer", [](const Json& map) { return map["report"]["viewer"].is_object(); });
    click("Clip:run");
    wait_for("a clip that runs", [](const Json& map) {
      return map["report"]["viewer"]["clip"] == "run" && map["report"]["viewer"]["seconds"] > 0;
    });
    press("Escape");
    wait_for("the crowd", [](const Json& map) { return map["report"]["viewer"].is_null(); });
  }
  void tune_to_one_pixel() {
    open_tab("LOD skipping");
    type_in_tab("Error limit.field", "4");
    wait_for("4 pixels", [](const Json& map) { return map["tuning"]["error_px"] == 4.0; });
    type_in_tab("Error limit.field", "1");
    const Json map = wait_for("an error of one pixel at most, of enough samples", [](const Json& now) {
      const Json& error = now["report"]["error"];
      return now["tuning"]["error_px"] == 1.0 && error["samples"] >= 200 && error["p99"] <= 1.0;
    });
    EXPECT_GT(map["report"]["error"]["history"], 0);
    bring_into_sight("Error history");
  }
  void compare_a_with_b() {
    open_tab("Presets");
    click_in_tab("Copy A to B");
    press("b");
    wait_for("B", [](const Json& map) { return map["shows_b"] == true; });
    open_tab("LOD skipping");
    type_in_tab("Largest interval.field", "4");
    wait_for("another B", [](const Json& map) { return map["tuning"]["largest_interval"] == 4; });
    press("b");
    wait_for("A", [](const Json& map) { return map["shows_b"] == false && map["tuning"]["largest_interval"] != 4; });
  }
  void resize_to(glm::ivec2 size) {
    xdotool({"search", "--name", "^Throng$", "windowsize", std::to_string(size.x), std::to_string(size.y)});
    wait_for(size_words(size), [&](const Json& map) { return map["size"] == Json::array({size.x, size.y}); });
    open_tab("Scheduling");
    open_tab("Crowd");
  }
  Json export_lod() {
    open_tab("Per-bone LOD");
    click_in_tab("Export LOD");
    wait_for_message(".lod.export.json");
    return json_of(folder() / "tiny.glb.lod.export.json");
  }
  std::vector<std::string> copy_as_command_line() {
    open_tab("Presets");
    click_in_tab("Copy as command line");
    wait_for_message("Copied");
    return throng::test::words_for_the_program(program().read_line(soon()).value_or(""));
  }
  void save_the_crowd() {
    open_tab("Presets");
    type_in_tab("Crowd name.field", "day");
    click_in_tab("Save crowd");
    wait_for_message("day.throng");
  }
  void leave() {
    xdotool({"key", "Escape"});
    EXPECT_EQ(program().exit_status(soon()), 0) << "all that was tuned is kept, so nothing is asked";
  }
  /// Returns the hash of the poses after some frames of a crowd.
  Json hash_of_poses(std::vector<std::string> words) {
    const fs::path file = folder() / "run.json";
    words.insert(words.begin(), THRONG_PROGRAM);
    for (const std::string& word : {std::string("--headless=none"), std::string("--size"), size_words(screen()),
                                    "--frames=" + std::to_string(frames), "--stats=" + file.string()}) {
      words.push_back(word);
    }
    ChildProcess run(words, {}, folder().string());
    EXPECT_EQ(run.exit_status(soon()), 0);
    return json_of(file)["pose_hash"];
  }
  Json hash_of_poses_in_a_window(const std::string& file) {
    const fs::path stats = folder() / "window.json";
    start_program({file, "--size", size_words(screen()), "--ui-scale", GetParam().scale, "--dt=0.0166666667",
                   "--frames=" + std::to_string(frames), "--stats=" + stats.string()});
    EXPECT_EQ(program().exit_status(soon()), 0);
    return json_of(stats)["pose_hash"];
  }
};

TEST_P(Workday, EndsWithAFileThatBringsAllOfItBack) {
  ASSERT_NO_FATAL_FAILURE(open_a_model("giant.glb", 44));
  ASSERT_NO_FATAL_FAILURE(look_at_it_alone());
  ASSERT_NO_FATAL_FAILURE(open_a_model("tiny.glb", 0.028));
  ASSERT_NO_FATAL_FAILURE(look_at_it_alone());
  ASSERT_NO_FATAL_FAILURE(give_a_clip_to_a_role_after_a_look("Walk", "jog"));
  ASSERT_NO_FATAL_FAILURE(tune_to_one_pixel());
  ASSERT_NO_FATAL_FAILURE(compare_a_with_b());
  ASSERT_NO_FATAL_FAILURE(resize_to(screen() * 3 / 4));
  ASSERT_NO_FATAL_FAILURE(resize_to(screen()));
  const Json exported = export_lod();
  ASSERT_TRUE(exported.is_object());
  const std::vector<std::string> command_line = copy_as_command_line();
  ASSERT_NO_FATAL_FAILURE(save_the_crowd());
  leave();

  const Json poses = hash_of_poses({"day.throng"});
  EXPECT_TRUE(poses.is_string());
  EXPECT_EQ(hash_of_poses(command_line), poses);
  EXPECT_EQ(hash_of_poses_in_a_window("day.throng"), poses);
  start_program({"day.throng", "--size", size_words(screen()), "--ui-scale", GetParam().scale});
  EXPECT_EQ(export_lod(), exported);
}

INSTANTIATE_TEST_SUITE_P(AtDesks, Workday,
                         testing::Values(Desk{{1280, 720}, "1"}, Desk{{1920, 1080}, "1"}, Desk{{2560, 1440}, "2"}),
                         [](const auto& desk) { return "Of" + size_words(desk.param.screen); });

}  // namespace
}  // namespace throng::app::workday_test
