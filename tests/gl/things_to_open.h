// The kinds of things that can be open in a show, and the files that they need.
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/character/bone_lod.h"
#include "app/people/wardrobe/cast_rules_text.h"
#include "app/people/wardrobe/cast_tuning.h"
#include "app/show/request/crowd_file.h"
#include "app/show/stage/stage.h"
#include "tests/own_folder.h"

namespace throng::app::described_crowd_test {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

/// A thing that can be open: how a run begins with it, and what a person does then.
struct Kind {
  std::string name;
  Words begun_with;
  std::function<std::vector<CrowdRequest>(const Stage&)> asked = {};
  std::function<void(CrowdSetup&)> kept_by_the_window = {};
};

void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }
std::string name_of(const testing::TestParamInfo<Kind>& kind) { return kind.param.name; }

/// The folder of the files of the tests, whose names a shell would take apart.
class Files {
 public:
  Files() {
    fs::create_directories(path("models"));
    fs::copy_file(features() / "plain.glb", path("models/a man's $HOME.glb"));
    fs::copy_file(features() / "linear-trs.glb", path("models/two.glb"));
    fs::copy_file(features() / "cubic-trs.glb", path("models/with,comma*2.glb"));
    fs::copy_file(features() / "partial-clips.glb", path("models/clips of others.glb"));
    std::ofstream walk(path("a walk.csv"));
    walk << "id,time,x,y\n";
    for (int row = 0; row <= 40; ++row) {
      for (int person = 0; person < 6; ++person) {
        walk << 'p' << person << ',' << 250 * row << ',' << 30 * row << ',' << 120 * person << '\n';
      }
    }
    std::ofstream(path("hall of 2.wkt")) << "POLYGON ((-2 -2, 14 -2, 14 9, -2 9, -2 -2))\n";
    std::ofstream(path("flight.csv")) << "time,x,y,z,yaw,pitch\n0,0,3,12,0,-10\n2,6,3,12,20,-10\n";
  }
  std::string path(const std::string& name) const { return (folder_.path() / "things to open" / name).string(); }

 private:
  static fs::path features() { return fs::path(THRONG_SOURCE_DIR) / "tests/data/features"; }
  const throng::test::OwnFolder folder_;
};

const Files& files() {
  static const Files all;
  return all;
}

Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

Words tracks(const Words& more = {}) {
  return Words{"--trajectories", "@a walk.csv", "--time-unit", "ms", "--unit", "cm"} + more;
}

std::vector<CrowdRequest> other_roles(const Stage& stage) {
  RoleClips clips = stage.people().front().roles.clips;
  int& walk = clips[index_of(Role::walk)];
  walk = walk == 0 ? no_clip : 0;
  return {SetRoles{0, clips}};
}

std::vector<CrowdRequest> other_bones(const Stage& stage) {
  const anim::Skeleton& skeleton = stage.people().front().character->skeleton;
  BoneLodChoice choice = present_bone_lod(skeleton.bones.size(), skeleton.level_bone_counts);
  choice.level_counts.back() -= 1;
  return {SetBones{0, choice}};
}

std::vector<CrowdRequest> other_body(const Stage& stage) {
  return {SetBody{0, {{anim::BodyRole::head, stage.people().front().character->skeleton.bones.front().name}}}};
}

std::vector<CrowdRequest> other_values(const Stage& stage) {
  Tuning tuning = stage.tuning();
  tuning.debug_view = DebugView::interval;
  tuning.seed = 9;
  tuning.light.sun_elevation = 20.0F;
  tuning.inspection.forced_interval = 3;
  return {Apply{tuning}};
}

std::vector<CrowdRequest> other_rules(const Stage& stage) {
  CastRules rules = stage.clothing().front().rules;
  CastTuning tuning = cast_tuning(rules, "plaza");
  tuning.things = 0.25F;
  tuning.seed = 5;
  tune(rules, "plaza", tuning);
  return {SetRules{0, rules_text(rules), files().path("of mine.cast.json")}};
}

std::vector<CrowdRequest> other_moment(const Stage& stage) {
  TrackClock clock = *stage.track_clock();
  clock.rate = -0.5;
  clock.repeats = true;
  return {Seek{gone_to(with_part(clock, 2.0, 8.0), 6.125)}};
}

std::vector<CrowdRequest> another_scene(const Stage& stage) {
  Tuning tuning = stage.tuning();
  tuning.scene = Scene::grid;
  tuning.agents = 11;
  return {other_moment(stage).front(), Apply{tuning}};
}

std::vector<CrowdRequest> other_models(const Stage& /*stage*/) {
  return {LoadModels{{files().path("models/two.glb"), files().path("models/a man's $HOME.glb")}}};
}

std::vector<CrowdRequest> other_placement(const Stage& /*stage*/) {
  return {SetPlacement{0, {.scale = 0.75, .up = anim::UpAxis::z}}};
}

std::vector<CrowdRequest> another_cast(const Stage& /*stage*/) {
  ChosenCharacter man{.file = files().path("models/a man's $HOME.glb")};
  ChosenCharacter other{.file = files().path("models/with,comma*2.glb"), .placement = {.scale = 0.5}};
  other.clip_files = {files().path("models/clips of others.glb")};
  return {SetCast{{man, other}}};
}

auto share(double share) {
  return [share](const Stage&) { return std::vector<CrowdRequest>{SetShare{1, share}}; };
}

void compare_two(CrowdSetup& setup) {
  Tuning other;
  other.agents = 12;
  setup.pair.take_other(other, "far & wide");
}

void keep_places(CrowdSetup& setup) {
  setup.bookmarks[0] = CameraPose{.x = 1, .y = 2.5F, .z = -3};
  setup.bookmarks[8] = CameraPose{.x = 0.1F};
}

/// Kinds of characters and of what a person chose for them.
std::vector<Kind> kinds_of_characters() {
  const std::string man = "@models/a man's $HOME.glb", two = "@models/two.glb", odd = "@models/with,comma*2.glb";
  const Words agents{"--agents", "9"};
  return {
      {"TheBuiltInCharacter", agents},
      {"Values", agents, other_values},
      {"Models", agents + Words{man, two}},
      {"DroppedModels", agents, other_models},
      {"AnotherCast", agents, another_cast},
      {"AModelOfAnOddName", agents + Words{odd}},
      {"Shares", agents + Words{man, two}, share(3.5)},
      {"ASmallShare", agents + Words{man, two}, share(0.001)},
      {"Roles", agents, other_roles},
      {"RolesOfOneOfTwo", agents + Words{man, two}, other_roles},
      {"OrderOfBones", agents, other_bones},
      {"PartsOfTheBody", agents + Words{man}, other_body},
      {"Placement", agents + Words{man}, other_placement},
      {"PlacementOfTheBuiltInCharacterBesideTracks", tracks(), other_placement},
      {"LentClips", agents + Words{man, "--clips-from", "@models/clips of others.glb"}},
      {"Rules", agents, other_rules},
  };
}

/// Kinds of recorded crowds, of cameras and of what the window keeps.
std::vector<Kind> kinds_of_views() {
  const std::string man = "@models/a man's $HOME.glb", two = "@models/two.glb";
  const Words agents{"--agents", "9"};
  return {
      {"ARecordedCrowd", tracks()},
      {"ARecordedCrowdWithWalls", tracks({"--walls", "@hall of 2.wkt", "--lenient", "--height=none"})},
      {"ARecordedCrowdThatPointsUp", tracks({"--up", "y"})},
      {"ARecordedCrowdOfModels", tracks({man, two, "--up", "z,a walk=y"})},
      {"AMomentAndAPart", tracks(), other_moment},
      {"ColoursAndTrails", tracks({"--start", "6", "--colours", "speed", "--trails", "4", "--set", "top_speed=1.5"})},
      {"ARecordedCrowdBehindAnotherScene", tracks(), another_scene},
      {"APlaceOfTheCamera", agents + Words{"--camera", "-3,2,9,10.5,-5,40"}},
      {"APathOfTheCamera", agents + Words{"--camera", "-3,2,9,10.5,-5,40", "--camera-path", "orbit"}},
      {"AFlightOfTheCamera", agents + Words{"--camera-path", "@flight.csv"}},
      {"ACameraBehindAPerson", tracks({"--camera", "follow:p3"})},
      {"ACameraBehindAnAgent", agents + Words{"--camera", "follow:#4"}},
      {"AFilm", agents + Words{"--scene", "film"}},
      {"TuningsToCompare", agents, {}, compare_two},
      {"PlacesOfTheCamera", agents + Words{man}, {}, keep_places},
  };
}

}  // namespace
}  // namespace throng::app::described_crowd_test
