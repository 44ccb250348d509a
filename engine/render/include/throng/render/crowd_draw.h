#pragma once

#include <cstdint>
#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "throng/host.h"
#include "throng/render/agent_look.h"
#include "throng/render/crowd_batch.h"
#include "throng/render/crowd_mesh_data.h"
#include "throng/render/instance_record.h"
#include "throng/render/scene_ground.h"
#include "throng/render/scene_light.h"

namespace throng::render {

struct CameraView {
  glm::vec3 position{0.0F};
  glm::mat4 view{1.0F};
  glm::mat4 projection{1.0F};
};

/// A straight line in the world. It is equally wide everywhere on the screen.
struct SceneLine {
  glm::vec3 from{0.0F};
  glm::vec3 to{0.0F};
  std::uint32_t color = 0xFFFFFFFF;  ///< sRGB, red in the lowest byte, alpha in the highest
};

/// Names palette entries side by side, 0 to 65535.
struct WeighedEntries {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// The jobs that parts of a picture's work are cut into. The renderer starts no threads.
struct RenderJobs {
  Executor* executor = nullptr;  ///< a host's job system; null: the calling thread does all
  int at_once = 1;               ///< the jobs that run at a time
};

/// Holds everything that one picture needs, as plain data that is valid during the call.
struct CrowdFrame {
  CameraView camera;
  std::span<const InstanceRecord> instances;     ///< one a drawn agent, in ascending order of page, then character
  std::span<const CrowdBatch> batches;           ///< in the same order
  std::uint32_t now = 0;                         ///< microseconds modulo 2^32, the clock of InstanceRecord::blend_start
  bool bones_as_lines = false;                   ///< the bones are drawn over the characters
  bool fill_pixels = true;                       ///< false: everything is drawn, but no pixel is filled
  std::span<const SceneLine> lines = {};         ///< drawn over the crowd, faintly where something is before them
  std::span<const SceneLine> ground_lines = {};  ///< drawn where nothing is before them
  std::span<const float> morph_weights = {};     ///< of instances whose records say where theirs are
  float distance_scale = 1.0F;  ///< the scene's distances over usual ones among people; haze is thinner by it
  SceneLight light = {};
  SceneGround ground = {};
  float scenery_error_px = 1.0F;  ///< pixels that a coarser mesh of scenery is off at most
  bool scenery = false;           ///< the instances of Renderer::place_scenery() are drawn
  bool shadows = true;            ///< everything casts shadows on everything
  bool crowd_shade = true;        ///< bodies keep the light of the sky from each other and from the ground
  WeighedEntries weighed = {};    ///< each vertex shows as a colour how much it follows these; none: no vertex does
  std::span<const AgentLook> looks = {};  ///< [agent]; empty: all have plain_look()
  std::uint64_t looks_number = 0;         ///< of these looks alone (new_looks_number); looks are copied when it changes
  /// Has the indices of the instances of each batch, in ascending order; empty: batches are runs of `instances`.
  std::span<const std::uint32_t> drawn = {};
  /// Has the runs of `instances` that share a page and a character; read where `drawn` is not empty.
  std::span<const CrowdBatch> runs = {};
  /// The first mesh LOD at which pieces have the mean colours of their patterns, and no fabrics and faces of their own.
  std::size_t first_plain_lod = first_silhouette_lod;
  RenderJobs jobs = {};
};

/// Returns the runs of a frame's instances that share a page and a character; some may follow each other.
inline std::span<const CrowdBatch> runs_of_instances(const CrowdFrame& frame) {
  return frame.drawn.empty() ? frame.batches : frame.runs;
}

/// The difference of two pictures is shown so many times as bright.
inline constexpr float difference_amplification = 8.0F;

/// Says how two pictures share one.
struct SplitView {
  float divider = 0.5F;     ///< the left picture fills this share of the width
  bool difference = false;  ///< beyond it, show the amplified difference of the two instead of the right one
};

struct DrawCounts {
  std::uint32_t draw_calls = 0;  ///< calls to OpenGL; a multi-draw counts as one
  std::uint64_t triangles = 0;
};

inline void add(DrawCounts& sum, const DrawCounts& more) {
  sum.draw_calls += more.draw_calls;
  sum.triangles += more.triangles;
}

}  // namespace throng::render
