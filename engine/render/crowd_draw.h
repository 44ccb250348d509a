#pragma once

#include <cstdint>
#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "engine/render/instance_record.h"

namespace throng::render {

/// One run of instances that share palette page, character and mesh LOD.
struct CrowdBatch {
  std::uint32_t page = 0;
  std::uint8_t character = 0;  ///< in the order in which they were loaded
  std::uint8_t mesh_lod = 0;   ///< 0 is the full mesh
  std::uint32_t first_instance = 0;
  std::uint32_t instance_count = 0;
};

struct CameraView {
  glm::vec3 position{0.0F};
  glm::mat4 view{1.0F};
  glm::mat4 projection{1.0F};
};

/// A straight line in the world, of an even width on the screen.
struct SceneLine {
  glm::vec3 from{0.0F};
  glm::vec3 to{0.0F};
  std::uint32_t color = 0xFFFFFFFF;  ///< sRGB, red in the lowest byte, alpha in the highest
};

/// All that one picture needs: plain data, valid for the call.
struct CrowdFrame {
  CameraView camera;
  std::span<const InstanceRecord> instances;
  std::span<const CrowdBatch> batches;  ///< in ascending order of page, then character
  std::uint32_t now = 0;                ///< microseconds modulo 2^32, the clock of InstanceRecord::blend_start
  bool bones_as_lines = false;
  bool fill_pixels = true;                ///< false: all is drawn, but no pixel is filled
  std::span<const SceneLine> lines = {};  ///< drawn over the crowd
};

/// Two pictures in one.
struct SplitView {
  float divider = 0.5F;     ///< share of the width, from the left, that shows the left picture
  bool difference = false;  ///< beyond it, how far the two are apart, eight times as bright; else the right picture
};

struct DrawCounts {
  std::uint32_t draw_calls = 0;  ///< calls of the device; a multi-draw is one
  std::uint64_t triangles = 0;
};

}  // namespace throng::render
