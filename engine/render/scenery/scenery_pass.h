#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "throng/render/crowd_draw.h"
#include "throng/render/scenery_data.h"

#include "engine/base/result.h"
#include "engine/render/gl/handles.h"
#include "engine/render/light/light_parts.h"
#include "engine/render/passes/indirect_draws.h"
#include "engine/render/scenery/selection.h"
#include "engine/render/shader/program_variants.h"

namespace throng::render {

/// Follows the parts of the light (light_parts.h): what scatters light is lit at its vertices, as suits a processor.
/// Not with shadows or lamps.
inline constexpr std::uint32_t scenery_lit_at_vertices = 1U << light_part_count;

/// Draws all scenery around a crowd with three calls: depths, surfaces that scatter light, and surfaces that mirror
/// too. Frame data and light must be bound.
class SceneryPass {
 public:
  /// `shaders` must outlive the pass.
  explicit SceneryPass(ShaderLibrary& shaders);

  /// Replaces the meshes, and takes all instances away. Errors: the device has no memory for them.
  Status load(std::span<const SceneryMeshData> meshes);
  /// Replaces the instances. SceneryInstance::mesh is an index into the meshes.
  void place(std::span<const SceneryInstance> instances);

  /// Draws the scenery in view, into the colours and depths that are bound. Allocates nothing.
  /// `light` has the parts of the light (light_parts.h), and scenery_lit_at_vertices or not.
  DrawCounts draw(const CameraView& camera, float picture_height, std::uint32_t light);
  /// Draws the depths of the scenery that draw() draws for the same view.
  DrawCounts draw_depth_in_view(const CameraView& camera, float picture_height);
  /// Draws depths alone along parallel rays, with coarser meshes, into the target that is bound. Depth tests and
  /// offsets are the caller's. `texel_metres` is the size of a texel.
  DrawCounts draw_depth(const glm::mat4& view_projection, float texel_metres);

 private:
  /// A run of the index buffer: triangles that scatter light, then triangles that mirror too.
  struct LodRun {
    std::uint32_t first_index;
    std::uint32_t matt_count;
    std::uint32_t mirror_count;
  };
  enum Part : std::uint8_t { whole, matt, mirrors, part_count };

  void compose(std::uint32_t parts);
  DrawCounts draw_own_depth();
  DrawCounts draw_part(Part part) const;

  ProgramVariants matt_;
  ProgramVariants mirror_;
  const gl::Program& own_depth_;
  const gl::Program& depth_;
  gl::Buffer vertices_;
  gl::Buffer indices_;
  gl::Buffer instances_;
  gl::VertexArray array_;
  std::vector<SceneryShape> shapes_;
  std::vector<std::vector<LodRun>> lods_;  // [mesh][LOD]
  std::vector<std::int32_t> first_vertices_;
  ScenerySelection selection_;
  std::vector<DrawCommand> commands_;                  // by part
  std::array<std::uint32_t, part_count + 1> parts_{};  // [part] where its commands begin
  std::array<std::uint64_t, part_count> triangles_{};
  gl::GrowingBuffer<std::uint32_t> chosen_;
  gl::GrowingBuffer<DrawCommand> command_buffer_;
};

}  // namespace throng::render
