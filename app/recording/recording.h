#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "app/character/bone_lod.h"
#include "app/character/roles.h"
#include "app/recording/recorded_character.h"
#include "app/settings/settings.h"
#include "engine/anim/base/units.h"
#include "engine/render/camera.h"

namespace throng::app {

/// A recording is what a crowd was asked to do and what became of it, frame by frame, in one file. Numbers are
/// little-endian; lengths are in bytes.
///
///     "THRONGRC"  version u32  length u32  header: JSON          RecordingHeader
///     kind u8  length u32  payload                               again and again: what was asked, then a frame
///
///     kind        payload
///     tuning      JSON of the values that changed (app/settings/preset.h)
///     selection   agent u32, 2^32 - 1 for nobody
///     push        agent u32, direction 3 x f32
///     roles       character u32, a clip i32 for each role
///     hold        agent u32, 2^32 - 1 to let go; seconds of its clip f32
///     rewind      nothing
///     bone order  character u32, bones u32, levels u32, each bone's index in the order of before u16, the levels'
///                 counts u16
///     characters  JSON, as in the header
///     share       character u32, share of the crowd f64
///     rig         JSON: the index of a "character", and its "rig" as in MODEL.throng.json
///     placement   JSON: the index of a "character", and its "placement" as in the header
///     rules       JSON: the index of a "character", and its "rules" as in the header
///     frame       delta i64 (ticks), camera 6 x f32, width u32, height u32, pose hash u64, agents u32,
///                 a bit for each agent whose hash changed, from the lowest; their hashes, u16
///     end         frames u64, ByteHash u64 of all bytes of the file before it
inline constexpr std::string_view recording_magic = "THRONGRC";
inline constexpr std::uint32_t recording_version = 3;
inline constexpr std::uint32_t recorded_nobody = 0xFFFFFFFFU;
inline constexpr std::uint32_t end_payload_bytes = 16;
enum class RecordKind : std::uint8_t {
  tuning = 1,
  selection,
  push,
  roles,
  hold,
  rewind,
  bone_order,
  characters,
  frame,
  end,
  share,
  rig,
  placement,
  rules
};

struct RecordingHeader {
  std::vector<RecordedCharacter> characters;  ///< people, 1 to most_models
  Tuning tuning;                              ///< of the first frame, with its cost coefficients
  int width = 0, height = 0;                  ///< pixels
};

/// The camera and the size of the picture that level of detail decided by.
struct LodView {
  render::Camera camera;
  int width = 0, height = 0;
};

struct RecordedSelection {
  std::optional<std::uint32_t> agent;
};
struct RecordedPush {
  std::uint32_t agent = 0;
  glm::vec3 direction{0.0F};  ///< of the world
};
struct RecordedRoles {
  std::uint32_t character = 0;
  RoleClips clips = no_clips();
};
struct RecordedHold {
  std::optional<std::uint32_t> agent;  ///< the agent whose clip is held; none: the clip is let go
  float seconds = 0;
};
struct RecordedRewind {};
struct RecordedBoneOrder {
  std::uint32_t character = 0;
  BoneLodChoice choice;
};
struct RecordedShare {
  std::uint32_t character = 0;
  double share = 1.0;
};
/// The parts of a character's body that a person says, in place of those before.
struct RecordedRig {
  std::uint32_t character = 0;
  std::vector<RigChoice> choices;
};
/// Another size and place of a character.
struct RecordedPlacement {
  std::uint32_t character = 0;
  anim::PlacementChoice choice;
};
/// Other rules by which a character's agents dress.
struct RecordedRules {
  std::uint32_t character = 0;
  std::string rules;  ///< as RecordedCharacter::rules
};
/// Other characters for all agents.
struct RecordedCharacters {
  std::vector<RecordedCharacter> characters;  ///< 1 to most_models, each from a file
};
/// A request that a person made between two frames.
using RecordedRequest =
    std::variant<Tuning, RecordedSelection, RecordedPush, RecordedRoles, RecordedHold, RecordedRewind,
                 RecordedBoneOrder, RecordedCharacters, RecordedShare, RecordedRig, RecordedPlacement, RecordedRules>;

struct RecordedFrame {
  anim::Ticks delta{};  ///< 0 while paused
  LodView view;
  std::uint64_t pose_hash = 0;
};
/// Follows the last frame. A recording without it was cut short.
struct RecordedEnd {
  std::uint64_t frames = 0;
};
using RecordedItem = std::variant<RecordedRequest, RecordedFrame, RecordedEnd>;

/// Returns the part of an agent's hash that a recording keeps.
constexpr std::uint16_t short_hash(std::uint64_t hash) { return static_cast<std::uint16_t>(hash >> 48U); }

/// Returns the values of `tuning` that differ from `before`, as app/settings/preset.h writes them.
std::string changed_values(const Tuning& before, const Tuning& tuning);

std::string header_text(const RecordingHeader& header);
/// Returns what is wrong, as the end of a sentence; nothing where the header was read.
std::optional<std::string> read_header(std::string_view text, RecordingHeader& header);

}  // namespace throng::app
