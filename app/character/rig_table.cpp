#include "app/character/rig_table.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "app/character/bone_lod.h"
#include "app/files/joined.h"
#include "app/files/nearest_names.h"

namespace throng::app {

anim::Result<std::vector<RigChoice>> rig_choices_in(const Json& rig, const JsonFile& file) {
  if (!rig.is_object()) return file.wrong("\"rig\" must be an object of parts of the body and names of bones");
  std::vector<RigChoice> choices;
  for (const auto& [part, bone] : rig.members()) {
    const auto role = anim::body_role_named(part);
    if (!role) {
      return file.wrong("\"rig\" has no part \"" + part + "\"; it knows " +
                        joined(anim::body_role_names, ", ", " and "));
    }
    if (!bone.is<std::string>()) return file.wrong("\"rig\": \"" + part + "\" must be the name of a bone");
    choices.push_back({*role, bone.get<std::string>()});
  }
  return choices;
}

Json rig_json(std::span<const RigChoice> choices) {
  Json rig = Json::object();
  for (const auto& [role, bone] : choices) rig[anim::name_of(role)] = bone;
  return rig;
}

anim::Status choose_bones(std::span<const RigChoice> choices, anim::Skeleton& skeleton) {
  const std::vector<std::string> keys = bone_keys(skeleton);
  std::vector<anim::Bone> bones = skeleton.bones;
  for (const auto& [role, key] : choices) {
    const auto found = std::ranges::find(keys, key);
    if (found == keys.end()) {
      return anim::Error{std::string(anim::name_of(role)) + "=" + key +
                         ": the skeleton has no such bone; nearest are " + nearest_names(key, keys)};
    }
    for (anim::Bone& bone : bones) {
      if (bone.role == role) bone.role.reset();
    }
    bones[static_cast<std::size_t>(found - keys.begin())].role = role;
  }
  skeleton.bones = std::move(bones);
  return anim::Done{};
}

}  // namespace throng::app
