#include "engine/anim/asset/placement.h"

#include <cassert>

#include <glm/gtc/matrix_transform.hpp>

namespace throng::anim {

namespace {

/// The vertices of a rigid skeleton lie in the space of the bind pose, which moves as a whole.
void place_mesh(SkinnedMesh& mesh, const Placement& placement, const glm::dmat4& matrix) {
  for (glm::vec3& position : mesh.positions) position = glm::vec3(matrix * glm::dvec4(glm::dvec3(position), 1.0));
  const auto turned = [&](const glm::vec3& v) { return placement.rotation * glm::dvec3(v); };
  for (glm::vec3& normal : mesh.normals) normal = glm::vec3(turned(normal));
  for (MorphDelta& delta : mesh.morph_deltas) {
    delta.position = glm::vec3(placement.scale * turned(delta.position));
    delta.normal = glm::vec3(turned(delta.normal));
  }
}

void place_bind_pose(Model& model, const Placement& placement, const glm::dmat4& matrix) {
  for (ReferenceFrame& frame : model.skeleton.references) {
    frame.rotation = placement.rotation * frame.rotation;
    frame.origin = glm::dvec3(matrix * glm::dvec4(frame.origin, 1.0));
    frame.scale *= placement.scale;
  }
  for (Skin& skin : model.skins) skin.bind_to_model = matrix * skin.bind_to_model;
  visit_surfaces(model, [&](std::vector<SkinnedMesh>& meshes) {
    for (SkinnedMesh& mesh : meshes) place_mesh(mesh, placement, matrix);
  });
}

}  // namespace

glm::dmat4 as_matrix(const Placement& placement) {
  const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), placement.offset);
  return glm::scale(moved * glm::mat4_cast(placement.rotation), glm::dvec3(placement.scale));
}

void place_model(Model& model, const Placement& placement) {
  assert(placement.scale > 0.0);
  if (placement == Placement{}) return;
  const glm::dmat4 matrix = as_matrix(placement);
  for (Bone& bone : model.skeleton.bones) {
    if (bone.parent < 0) bone.prefix = matrix * bone.prefix;
  }
  if (model.skeleton.rigid) place_bind_pose(model, placement, matrix);
  for (BakedMeshLod& lod : model.mesh_lods) lod.error *= placement.scale;
  for (ModelPart& part : model.parts) {
    for (BakedMeshLod& lod : part.lods) lod.error *= placement.scale;
  }
}

bool face_forward(Model& model) {
  if (!model.faces_backwards) return false;
  const Placement half_turn{.rotation = {0.0, 0.0, 1.0, 0.0}};
  place_model(model, half_turn);
  model.faces_backwards = false;
  return true;
}

void face_forward(ImportedFile& file) {
  bool turned = false;
  for (Model& model : file.models) turned |= face_forward(model);
  if (turned) file.notes.emplace_back("VRM 0.x looks along -Z: turned by half a turn");
}

}  // namespace throng::anim
