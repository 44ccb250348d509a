#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "engine/render/crowd_draw.h"
#include "engine/render/gl/handles.h"
#include "engine/render/passes/indirect_draws.h"
#include "engine/render/scenery/selection.h"
#include "engine/render/scenery_data.h"
#include "engine/render/shader/program_variants.h"
#include "engine/result.h"

namespace throng::render {

/// Draws what stands around a crowd, all of it with one call. Frame data and light must be bound.
class SceneryPass {
 public:
  /// `shaders` must outlive the pass.
  explicit SceneryPass(ShaderLibrary& shaders);

  /// Replaces the meshes, and takes all instances away. Errors: the device has no memory for them.
  Status load(std::span<const SceneryMeshData> meshes);
  /// Replaces the instances. SceneryInstance::mesh is an index into the meshes.
  void place(std::span<const SceneryInstance> instances);

  /// Draws what is in view, into the colours and depths that are bound. Allocates nothing.
  /// `light` has the parts of the light (light_parts.h).
  DrawCounts draw(const CameraView& camera, float picture_height, std::uint32_t light);
  /// Draws depths alone along parallel rays, with coarser meshes, into the target that is bound. Depth tests and
  /// offsets are the caller's. `texel_metres` is the size of a texel.
  DrawCounts draw_depth(const glm::mat4& view_projection, float texel_metres);

 private:
  /// A run of the index buffer: matt triangles, and after them those that mirror.
  struct LodRun {
    std::uint32_t first_index;
    std::uint32_t matt_count;
    std::uint32_t shiny_count;
  };
  enum class Part : std::uint8_t { matt, shiny, all };

  std::uint32_t add_triangles(const SceneryMeshData& mesh, const SceneryLodData& lod, bool shiny,
                              std::vector<std::uint32_t>& indices) const;
  void upload_chosen();
  DrawCounts draw_chosen(Part part);

  ProgramVariants surface_;
  const gl::Program& depth_;
  gl::Buffer vertices_;
  gl::Buffer indices_;
  gl::Buffer instances_;
  gl::VertexArray array_;
  std::vector<SceneryShape> shapes_;
  std::vector<std::vector<LodRun>> lods_;  // [mesh][LOD]
  std::vector<std::int32_t> first_vertices_;
  ScenerySelection selection_;
  std::vector<DrawCommand> commands_;  // of matt parts, then of those that mirror, or of both at once
  gl::GrowingBuffer<std::uint32_t> chosen_;
  gl::GrowingBuffer<DrawCommand> command_buffer_;
};

}  // namespace throng::render
