#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/character/roles.h"
#include "app/people/crowd/habits.h"
#include "app/show/report/tracked_person.h"
#include "engine/anim/base/pool.h"

namespace throng::app {

/// A value in the header of an entity's block.
struct BlockField {
  std::string name;
  std::string value;
};

/// The interval and the bone level that level of detail gave an agent in a frame.
struct LodOfFrame {
  bool visible = false;
  std::uint8_t interval = 1;
  std::uint8_t bone_level = 0;
};

/// One entity of an agent's graph, as its block stands after the last update.
struct EntityRow {
  std::string kind;
  std::string clip;            ///< the clip of a player; else empty
  float position_seconds = 0;  ///< a player's place in its clip
  float duration_seconds = 0;  ///< the length of a player's clip
  float weight = 0;            ///< its share of the pose that is shown, 0 to 1
  anim::Handle handle = {};
  int priority = 0;                      ///< 0: players, the highest; below 0: their readers
  bool resident = false;                 ///< keeps its transforms in main memory
  bool shared = false;                   ///< several agents read it
  std::vector<BlockField> fields = {};   ///< the fields of the block's header
  std::vector<std::uint8_t> block = {};  ///< the bytes of the block
};

/// A channel of an agent with its entities, or an entity that changes the pose of all channels.
struct LayerRow {
  std::string name;
  float weight = 1;        ///< its weight against the layers below, 0 to 1
  bool is_masked = false;  ///< it changes some bones only
  bool is_channel = true;
  std::vector<std::size_t> entities;  ///< places in SelectionReport::entities, readers after their sources
};

/// The overlay's words for the state of an agent in FallenAgents.
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
  int bone_level = 0;  ///< the level of the pose shown
  int bones = 0;       ///< the number of bones at that level
  int mesh_lod = 0;    ///< the mesh that it is drawn with; 0: the full one
  bool can_fall = false;
  int channels = 0;
  std::vector<EntityRow> entities;       ///< each once, readers after their sources, the pose last
  std::vector<LayerRow> layers = {};     ///< a later one lies over the earlier ones
  std::uint32_t bytes = 0;               ///< the size of all blocks
  std::vector<LodOfFrame> history = {};  ///< the last frames, oldest first
  std::vector<std::string> events = {};  ///< data keys that it met and clips that it began, the newest first
  std::optional<float> held_at = {};     ///< seconds: a person holds its clip there
  float clip_seconds = 0;                ///< length of the clip that it plays; 0: none
  std::shared_ptr<const TrackedPerson> tracked = {};  ///< of a recorded crowd; else null
};

}  // namespace throng::app
