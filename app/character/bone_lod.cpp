#include "app/character/bone_lod.h"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/files/json_file.h"
#include "engine/anim/base/pose.h"
#include "engine/anim/run/program/cost_model.h"
#include "engine/base/json/json_object.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;
constexpr int version = 1;
constexpr const char* remedy = "mend it, or delete it to have the order computed again";

// Words for people: a permutation, each bone after its parent.
Status check_order(const anim::Skeleton& skeleton, std::span<const int> bones) {
  const std::vector<std::string> names = bone_keys(skeleton);
  std::vector<bool> seen(names.size(), false);
  for (const int bone : bones) {
    if (bone < 0 || bone >= skeleton.bone_count()) return Error{"a bone that the model does not have"};
    const auto index = static_cast<std::size_t>(bone);
    const int parent = skeleton.bones[index].parent;
    if (seen[index]) return Error{"bone \"" + names[index] + "\" is listed twice"};
    if (parent >= 0 && !seen[static_cast<std::size_t>(parent)]) {
      return Error{"bone \"" + names[index] + "\" comes before its parent \"" +
                   names[static_cast<std::size_t>(parent)] + "\""};
    }
    seen[index] = true;
  }
  const auto missing = std::ranges::find(seen, false);
  if (missing == seen.end()) return Done{};
  return Error{"bone \"" + names[static_cast<std::size_t>(missing - seen.begin())] + "\" is missing"};
}

Status check_levels(std::span<const int> counts, int bones) {
  if (counts.empty() || counts.size() > max_bone_levels) {
    return Error{"there must be 1 to " + std::to_string(max_bone_levels) + " levels"};
  }
  if (counts.front() != bones) return Error{"level 0 must keep all " + std::to_string(bones) + " bones"};
  for (std::size_t level = 1; level < counts.size(); ++level) {
    if (counts[level] >= 1 && counts[level] < counts[level - 1]) continue;
    return Error{"level " + std::to_string(level) + " must keep at least 1 bone and fewer than level " +
                 std::to_string(level - 1)};
  }
  return Done{};
}

Result<BoneLodChoice> choice_in(const Json& table, const anim::Skeleton& skeleton, const JsonFile& file) {
  const std::initializer_list<std::string_view> keys = {"version", "bones", "level_counts"};
  std::optional<std::string> complaint;
  const JsonObject reader("", table, keys, complaint);
  reader.version(version);
  reader.need(keys);
  std::vector<std::string> names;
  reader.texts("bones", names);
  BoneLodChoice choice;
  reader.wholes("level_counts", choice.level_counts, 0, anim::max_bones);
  if (complaint) return file.wrong(*complaint);
  auto bones = bones_named(names, skeleton);
  if (!bones) return file.wrong("\"bones\": " + bones.error().message);
  choice.bones = std::move(*bones);
  if (const auto checked = check_bone_lod(skeleton, choice); !checked) return file.wrong(checked.error().message);
  return choice;
}

}  // namespace

std::vector<std::string> bone_keys(const anim::Skeleton& skeleton) {
  std::map<std::string_view, int> uses;
  for (const anim::Bone& bone : skeleton.bones) ++uses[bone.name];
  std::vector<std::string> keys;
  for (const anim::Bone& bone : skeleton.bones) {
    const bool alone = !bone.name.empty() && uses[bone.name] == 1;
    keys.push_back(alone ? bone.name : bone.name + "#" + std::to_string(bone.node));
  }
  return keys;
}

Result<std::vector<int>> bones_named(std::span<const std::string> keys, const anim::Skeleton& skeleton) {
  const std::vector<std::string> all = bone_keys(skeleton);
  std::map<std::string_view, int> by_key;
  for (std::size_t bone = 0; bone < all.size(); ++bone) by_key.emplace(all[bone], static_cast<int>(bone));
  std::vector<int> bones;
  for (const std::string& key : keys) {
    const auto found = by_key.find(key);
    if (found == by_key.end()) return Error{"the model has no bone \"" + key + "\""};
    bones.push_back(found->second);
  }
  return bones;
}

Status check_bone_lod(const anim::Skeleton& skeleton, const BoneLodChoice& choice) {
  const Status order = check_order(skeleton, choice.bones);
  return order ? check_levels(choice.level_counts, skeleton.bone_count()) : order;
}

BoneLodChoice present_bone_lod(std::size_t bones, std::vector<int> level_counts) {
  BoneLodChoice choice{.bones = std::vector<int>(bones), .level_counts = std::move(level_counts)};
  std::iota(choice.bones.begin(), choice.bones.end(), 0);
  return choice;
}

BoneLodChoice with_bone_moved(std::span<const int> parents, BoneLodChoice choice, std::size_t from, std::size_t to) {
  std::vector<int>& bones = choice.bones;
  const int moved = bones[from];
  const auto is_above = [&](int upper, int lower) {
    for (int bone = lower; bone >= 0; bone = parents[static_cast<std::size_t>(bone)]) {
      if (bone == upper) return true;
    }
    return false;
  };
  const auto at = [&](std::size_t place) { return bones.begin() + static_cast<std::ptrdiff_t>(place); };
  if (to < from) {
    std::stable_partition(at(to), at(from) + 1, [&](int each) { return is_above(each, moved); });
  } else {
    std::stable_partition(at(from), at(to) + 1, [&](int each) { return !is_above(moved, each); });
  }
  return choice;
}

double nanoseconds_a_bone() {
  const anim::CostModel cost;
  return (cost.player_packet + cost.tile_packet / anim::widest_strip) / anim::packet_bones;
}

double nanoseconds_at_level(const anim::Skeleton& skeleton, std::size_t level) {
  const anim::CostModel cost;
  const int packets = anim::packets_for(skeleton.level_bone_counts[level]);
  return cost.of_agent({.players = 1}, packets) + cost.of_tile(packets) / anim::widest_strip;
}

BoneLodFile::BoneLodFile(const fs::path& model) : file_(model, ".lod.json", "The order of the bones") {}

Result<std::optional<BoneLodChoice>> BoneLodFile::read(const anim::Skeleton& skeleton) const {
  const fs::path found = file_.found();
  if (found.empty()) return std::optional<BoneLodChoice>();
  const JsonFile file(found, {.malformed = remedy, .wrong = remedy});
  const auto table = file.read();
  if (!table) return table.error();
  auto choice = choice_in(*table, skeleton, file);
  if (!choice) return choice.error();
  return std::optional(std::move(*choice));
}

Result<fs::path> BoneLodFile::write(const anim::Skeleton& skeleton) const {
  const Json table = {
      {"version", version}, {"bones", bone_keys(skeleton)}, {"level_counts", skeleton.level_bone_counts}};
  return file_.write(table.dump(2) + "\n");
}

}  // namespace throng::app
