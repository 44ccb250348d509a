#include "app/character/role_table.h"

#include <algorithm>
#include <optional>

#include "app/files/json_file.h"
#include "app/files/nearest_names.h"
#include "engine/base/json/json_object.h"

namespace throng::app {
namespace {

namespace fs = std::filesystem;

constexpr int role_table_version = 1;
constexpr JsonRemedies remedies{.malformed = "delete it to go by the names of clips and bones again"};

}  // namespace

Status choose_clips(std::span<const RoleChoice> choices, std::span<const std::string> clip_names, RoleClips& clips) {
  RoleClips chosen = clips;
  for (const auto& [role, name] : choices) {
    const auto found = std::ranges::find(clip_names, name);
    const std::string which = std::string(role_names.at(index_of(role))) + "=" + name;
    if (found == clip_names.end() && name != no_clip_name) {
      if (clip_names.empty()) return Error{which + ": the model has no clips; the only choice is none"};
      return Error{which + ": the model has no such clip; nearest are " + nearest_names(name, clip_names)};
    }
    chosen.at(index_of(role)) = found == clip_names.end() ? no_clip : static_cast<int>(found - clip_names.begin());
  }
  clips = chosen;
  return Done{};
}

std::vector<RoleChoice> all_choices(const RoleClips& clips, std::span<const std::string> clip_names) {
  std::vector<RoleChoice> choices;
  for (std::size_t role = 0; role < role_count; ++role) {
    const int clip = clips.at(role);
    choices.push_back(
        {static_cast<Role>(role), clip == no_clip ? no_clip_name : clip_names[static_cast<std::size_t>(clip)]});
  }
  return choices;
}

std::optional<std::string> read_role_choices(const Json& clips, std::vector<RoleChoice>& choices) {
  if (!clips.is_object()) return "\"clips\" must be an object of roles and clip names";
  for (const auto& [name, clip] : clips.members()) {
    const auto role = role_named(name);
    if (!role) return "\"clips\" has no role \"" + name + "\"; it knows " + known_roles();
    if (!clip.is<std::string>()) return "\"clips\": \"" + name + "\" must be the name of a clip, or \"none\"";
    choices.push_back({*role, clip.get<std::string>()});
  }
  return {};
}

Json clips_json(std::span<const RoleChoice> choices) {
  Json clips = Json::object();
  for (const auto& [role, clip] : choices) clips[role_names.at(index_of(role))] = clip;
  return clips;
}

RoleFile::RoleFile(const fs::path& model) : file_(model, ".throng.json", "The roles") {}

template <typename Choice>
Result<std::vector<Choice>> RoleFile::read_key(const char* key,
                                               std::optional<std::string> (*read_choices)(const Json&,
                                                                                          std::vector<Choice>&)) const {
  const fs::path found = file_.found();
  if (found.empty()) return std::vector<Choice>();
  const JsonFile file(found, remedies);
  const auto table = file.read();
  if (!table) return table.error();
  std::optional<std::string> complaint;
  JsonObject("", *table, {"version", "clips", "rig"}, complaint).version(role_table_version);
  std::vector<Choice> choices;
  if (!complaint && table->contains(key)) complaint = read_choices((*table)[key], choices);
  if (complaint) return file.wrong(*complaint);
  return choices;
}

Result<std::vector<RoleChoice>> RoleFile::read() const { return read_key("clips", read_role_choices); }

Result<std::vector<RigChoice>> RoleFile::read_rig() const { return read_key("rig", read_rig_choices); }

Result<fs::path> RoleFile::write(std::span<const RoleChoice> choices) const {
  const auto rig = read_rig();
  return rig ? write_both(choices, *rig) : rig.error();
}

Result<fs::path> RoleFile::write_rig(std::span<const RigChoice> choices) const {
  const auto clips = read();
  return clips ? write_both(*clips, choices) : clips.error();
}

Result<fs::path> RoleFile::write_both(std::span<const RoleChoice> clips, std::span<const RigChoice> rig) const {
  Json written = {{"version", role_table_version}};
  if (!clips.empty()) written["clips"] = clips_json(clips);
  if (!rig.empty()) written["rig"] = rig_json(rig);
  return file_.write(written.dump(2) + "\n");
}

}  // namespace throng::app
