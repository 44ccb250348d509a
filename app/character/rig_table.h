#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/character/rig_choice.h"
#include "engine/anim/asset/skeleton.h"
#include "engine/base/json/json.h"
#include "engine/base/result.h"

namespace throng::app {

/// Adds to `choices` what {"hips": "Bone.003", "leftFoot": "ankle.l"} says; the parts have VRM's names. Returns what is
/// wrong, as the end of a sentence.
std::optional<std::string> read_rig_choices(const Json& rig, std::vector<RigChoice>& choices);
Json rig_json(std::span<const RigChoice> choices);

/// Gives bones the parts that a person chose, over the file's own. Errors: the skeleton has no such bone, one bone is
/// chosen for two parts, or a part lies on the wrong side of another (misplaced_part); then nothing has changed.
Status choose_bones(std::span<const RigChoice> choices, anim::Skeleton& skeleton);

/// Returns the parts that the file or a person gave to bones.
std::vector<RigChoice> said_parts(const anim::Skeleton& skeleton);

/// The bone of each part, by BodyRole; -1 where none is known.
using PartBones = std::array<int, anim::body_role_count>;
/// Says which of the chosen parts cannot be where it is among `bones`, such as a foot whose bone is above the knee's;
/// nothing where all can.
std::optional<std::string> misplaced_part(std::span<const RigChoice> choices, const PartBones& bones,
                                          const anim::Skeleton& skeleton);

/// Returns the part as people say it: "left foot".
std::string words_of(anim::BodyRole role);

}  // namespace throng::app
