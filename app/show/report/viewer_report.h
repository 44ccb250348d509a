#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/character/roles.h"

namespace throng::app {

/// The choices of a person in the viewer of one character. The overlay edits a copy, as it does with the tuning.
struct ViewerSettings {
  int clip = 0;  ///< among the character's clips
  bool plays = true;
  bool loops = true;      ///< false: the clip stops at its end
  float speed = 1.0F;     ///< multiple of the clip's own, -2 to 4
  int blended = no_clip;  ///< a second clip, in step with the first; no_clip: none
  float weight = 0.5F;    ///< of the second clip, 0 to 1
  bool bind_pose = false;
  bool bones = false;     ///< drawn as lines
  bool bounds = false;    ///< drawn as lines
  bool turns = false;     ///< the turntable
  int weighed_bone = -1;  ///< colours show how much of the surface follows it; -1: none
  int bone_level = 0;
  int mesh_lod = 0;

  friend bool operator==(const ViewerSettings&, const ViewerSettings&) = default;
};

/// A clip in the viewer's list.
struct ViewedClip {
  std::string name;
  float seconds = 0;
  bool loops = false;  ///< its last pose is its first
};

/// A mesh LOD of the character.
struct ViewedMesh {
  std::size_t triangles = 0;
  float error_metres = 0;  ///< farthest from the full surface
};

/// A joint as it was drawn last.
struct ViewedJoint {
  std::size_t bone = 0;
  float x = 0, y = 0;  ///< shares of the picture's width and height, from its top left
};

/// A clip that a person chose for a role, and that is looked at before it is applied.
struct RolePreview {
  Role role = Role::stand;
  int clip = no_clip;
};

/// All that the overlay shows of the viewer.
struct ViewerReport {
  std::size_t character = 0;
  ViewerSettings settings = {};
  std::vector<ViewedClip> clips = {};       ///< at least one
  std::vector<std::string> bones = {};      ///< names, in the order of the skeleton
  std::vector<ViewedJoint> joints = {};     ///< in the picture; empty while bones are not drawn
  float seconds = 0;                        ///< in the clip
  float length = 0;                         ///< seconds, of the clip, or of both while they are blended
  float height = 0, reach = 0;              ///< metres: see anim::CharacterBounds
  float drawn_scale = 1;                    ///< so many times as large as it is
  std::vector<int> level_bones = {};        ///< [bone level]
  std::vector<ViewedMesh> meshes = {};      ///< [mesh LOD]; empty where nothing is drawn
  std::optional<RolePreview> preview = {};  ///< of this character
};

/// Asks for a character to be viewed alone.
struct ViewRequest {
  std::size_t character = 0;
  std::optional<std::uint32_t> agent = {};  ///< shown with its colours, and in the clip that it plays
  std::optional<int> clip = {};             ///< to play at first
  std::optional<RolePreview> preview = {};  ///< the clip to play at first, and the role that it is for
};

}  // namespace throng::app
