#include "throng/drawing.h"

#include <algorithm>
#include <vector>

#include <glm/mat4x3.hpp>

#include "throng/crowd.h"

#include "engine/anim/api/character_data.h"
#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/base/transform.h"
#include "engine/base/glm_numbers.h"
#include "engine/crowd/surface_data.h"

namespace throng {
namespace {

constexpr std::size_t most_measured_poses = 48;
constexpr Ticks between_poses = ticks_per_second / 4;

struct alignas(16) PaletteRoom {
  anim::PaletteMatrix matrix;
};

std::vector<glm::mat4x3> to_matrices(std::span<const PaletteRoom> palette) {
  std::vector<glm::mat4x3> matrices;
  for (const PaletteRoom& entry : palette) {
    glm::mat4x3& matrix = matrices.emplace_back();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) matrix[column][row] = entry.matrix.rows[row][column];
    }
  }
  return matrices;
}

/// Returns the rest pose, and poses of all clips at even times.
render::PosedPalettes posed_palettes(const Character& character) {
  const std::vector<glm::dmat4> rest = anim::reference_pose(character.data()->baked->skeleton, nullptr, 0.0).palette;
  render::PosedPalettes poses{{rest.begin(), rest.end()}};
  auto crowd = Crowd::create(character);
  if (!crowd) return poses;
  const AgentId agent = crowd->add_agent();
  std::vector<PaletteRoom> room(character.palette_entries() + 4);
  const PoseRequest request{.agent = agent, .palette = reinterpret_cast<std::byte*>(room.data())};
  Ticks length{};
  for (std::uint32_t clip = 0; clip < character.clip_count(); ++clip) length += character.clip({clip}).duration;
  const Ticks step = std::max(between_poses, length / std::int64_t{most_measured_poses});
  for (std::uint32_t clip = 0; clip < character.clip_count(); ++clip) {
    if (!character.has({clip})) continue;
    for (Ticks at{}; at < character.clip({clip}).duration && poses.size() < most_measured_poses; at += step) {
      crowd->agent(agent).play({.clip = {clip}, .start = at});
      crowd->update({&request, 1});
      poses.push_back(to_matrices(std::span(room).first(character.palette_entries())));
    }
  }
  return poses;
}

}  // namespace

Result<render::CrowdMeshData> mesh_data(const Character& character) {
  if (!character || character.data()->body->model.meshes.empty()) {
    return Error{"the character has no surface: load it with LoadOptions::keep_meshes"};
  }
  const detail::CharacterBody& body = *character.data()->body;
  const anim::Skeleton& skeleton = character.data()->baked->skeleton;
  render::CrowdMeshData data;
  for (const anim::SkinnedMesh& mesh : body.model.meshes) {
    data.parts.push_back(part_data(mesh, body.model.materials[static_cast<std::size_t>(mesh.material)]));
  }
  add_materials(body.model.materials, body.model.images, data);
  add_palette_data(skeleton, data);
  data.morph_deltas = morph_deltas(body.model.meshes);
  data.face_entries = face_entries(skeleton);
  data.bone_ends = bone_ends(skeleton);
  data.poses = posed_palettes(character);
  return data;
}

void look_from(ViewFrame& frame, const render::CameraView& eye, glm::ivec2 size) {
  const glm::mat4 clip_from_world = eye.projection * eye.view;
  const glm::vec3 forward(-eye.view[0][2], -eye.view[1][2], -eye.view[2][2]);
  frame.view = to_mat4(&eye.view[0][0]);
  frame.projection = to_mat4(&eye.projection[0][0]);
  frame.width = static_cast<float>(size.x);
  frame.height = static_cast<float>(size.y);
  frame.camera = camera_of(from_glm(eye.position), from_glm(forward), to_mat4(&clip_from_world[0][0]), size.y);
}

render::CrowdFrame crowd_frame(const render::CameraView& eye, const CrowdDraws& draws) {
  return {.camera = eye,
          .instances = draws.instances,
          .batches = draws.batches,
          .now = draws.now,
          .morph_weights = draws.morph_weights,
          .drawn = draws.drawn,
          .runs = draws.runs};
}

}  // namespace throng
