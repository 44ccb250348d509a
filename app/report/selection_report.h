#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/character/roles.h"
#include "app/crowd/habits.h"

namespace throng::app {

/// A value in the header of an entity's block.
struct BlockField {
  std::string name;
  std::string value;
};

/// What level of detail gave an agent in a frame.
struct LodOfFrame {
  bool visible = false;
  std::uint8_t interval = 1;
  std::uint8_t bone_level = 0;
};

/// One entity of an agent's graph, as its block stands after the last update.
struct EntityRow {
  std::string kind;
  std::string clip;                                   ///< of a player; else empty
  float position_seconds = 0;                         ///< of a player, in its clip
  float duration_seconds = 0;                         ///< of a player's clip
  float weight = 0;                                   ///< in the pose that is shown, 0 to 1
  std::uint32_t bytes = 0;                            ///< of its block
  std::uint32_t pool = 0, generation = 0, index = 0;  ///< its handle
  int priority = 0;                                   ///< 0 highest: players; below 0 what reads them
  bool resident = false;                              ///< keeps its transforms in main memory
  bool shared = false;                                ///< several agents read it
  std::vector<BlockField> fields = {};                ///< of the block's header
  std::vector<std::uint8_t> block = {};               ///< the bytes themselves
};

/// A channel of an agent and what it is made of, or what changes the pose of all of them.
struct LayerRow {
  std::string name;
  float weight = 1;        ///< how much of it is laid over what is below, 0 to 1
  bool is_masked = false;  ///< over some bones only
  bool is_channel = true;
  std::vector<std::size_t> entities;  ///< places in SelectionReport::entities, sources before what reads them
};

/// How a pushed agent is: Stage::fallen in the overlay's words.
enum class Posture : std::uint8_t { upright, falling, down, getting_up };

/// All that the overlay shows of the selected agent.
struct SelectionReport {
  std::uint32_t agent = 0;
  Role role = Role::other;
  Habit habit = Habit::stand_about;
  Posture posture = Posture::upright;
  float x = 0, y = 0, z = 0;  ///< metres
  float speed = 0;            ///< metres a second
  bool visible = false;
  int interval = 0;    ///< frames from one update to the next
  int bone_level = 0;  ///< of the pose shown
  int bones = 0;       ///< of that level
  bool can_fall = false;
  int channels = 0;
  std::vector<EntityRow> entities;       ///< each once, sources before what reads them, the pose last
  std::vector<LayerRow> layers = {};     ///< the later over the earlier
  std::uint32_t bytes = 0;               ///< of all blocks
  std::vector<LodOfFrame> history = {};  ///< of the last frames, oldest first
  std::vector<std::string> events = {};  ///< data keys met and clips begun, the newest first
  std::optional<float> held_at = {};     ///< seconds: its clip is held there by hand
  float clip_seconds = 0;                ///< of the clip that it plays; 0: none
};

}  // namespace throng::app
