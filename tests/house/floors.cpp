#include "tests/house/floors.h"

#include <algorithm>
#include <filesystem>
#include <optional>

namespace throng::house {
namespace {

namespace fs = std::filesystem;

constexpr int street = -1;  // the floor of a folder that is no room

/// The floor on which a folder lies, its own or that of the room around it.
int floor_of(const House& house, fs::path folder) {
  for (; !folder.empty(); folder = folder.parent_path()) {
    for (std::size_t floor = 0; floor < house.floors.size(); ++floor) {
      if (std::ranges::count(house.floors[floor], folder.generic_string()) > 0) return static_cast<int>(floor);
    }
  }
  return street;
}

/// "kernel/pose" for engine/anim/kernel/pose/blend.h; nothing for a file of another tree or one that lies in no folder.
std::optional<std::string> folder_within(const House& house, const std::string& path) {
  if (!path.starts_with(house.folder)) return {};
  const std::string folder = fs::path(path.substr(house.folder.size())).parent_path().generic_string();
  return folder.empty() ? std::nullopt : std::optional(folder);
}

}  // namespace

const std::vector<House>& houses() {
  static const std::vector<House> all{
      {"engine/anim/",
       {{"include/throng/c"},
        {"include/throng"},
        {"base"},
        {"asset"},
        {"rig"},
        {"survey"},
        {"import/bytes"},
        {"import/memory", "import/pixels"},
        {"kernel/lanes", "import", "retarget"},
        {"kernel/keyframe", "kernel/pose", "kernel/palette"},
        {"kernel/limb", "kernel/ragdoll"},
        {"kernel"},
        {"bake", "import/machine"},
        {"entity", "pack"},
        {"run/program"},
        {"run/store"},
        {"run/levels", "run/fused"},
        {"run"},
        {"lod"},
        {"agent"},
        {"agent/channel"},
        {"api"},
        {"api/c"},
        {"examples", "tools"}}},
      {"engine/render/",
       {{"include/throng/render"}, {"gl"}, {"shader", "palette", "frame"}, {"mesh", "light"}, {"passes"}, {"scenery"}}},
      {"engine/crowd/", {{"include/throng"}, {"examples"}}},
      {"engine/base/", {{"text"}, {"files"}, {"json"}}},
      {"app/",
       {{"files"},
        {"character"},
        {"settings"},
        {"people/crowd/numbers"},
        {"people/crowd/steering"},
        {"people/crowd"},
        {"people/wardrobe"},
        {"people/place"},
        {"people/measure"},
        {"show/camera"},
        {"show/lod"},
        {"show/report"},
        {"show/request"},
        {"show/stage"},
        {"show/viewer"},
        {"show/figures"},
        {"show/recording"},
        {"show"},
        {"output/regression"},
        {"output"},
        {"window/panel/controls"},
        {"window/panel"},
        {"window"},
        {"commands/bench", "commands/pose", "commands/inspect", "commands/check", "commands/compare"},
        {"commands/bake", "commands/lod"},
        {"commands/command_line"}}},
  };
  return all;
}

bool climbs(const House& house, const std::string& from, const std::string& to) {
  const auto above = folder_within(house, from);
  const auto below = folder_within(house, to);
  if (!above || !below || *above == *below) return false;
  const int from_floor = floor_of(house, *above), to_floor = floor_of(house, *below);
  return from_floor == street || to_floor == street || to_floor >= from_floor;
}

}  // namespace throng::house
