#include "engine/anim/asset/model_space.h"

#include <glm/gtc/matrix_transform.hpp>

namespace throng::anim {

namespace {

void turn_surface(SkinnedMesh& mesh, const glm::quat& turn) {
  for (glm::vec3& position : mesh.positions) position = turn * position;
  for (glm::vec3& normal : mesh.normals) normal = turn * normal;
}

}  // namespace

void turn_model(Model& model, const glm::dquat& turn) {
  const glm::dmat4 matrix = glm::mat4_cast(turn);
  for (Bone& bone : model.skeleton.bones) {
    if (bone.parent < 0) bone.prefix = matrix * bone.prefix;
  }
  if (!model.skeleton.rigid) return;  // palettes then lead from the vertices' own space
  for (ReferenceFrame& frame : model.skeleton.references) {
    frame.rotation = turn * frame.rotation;
    frame.origin = turn * frame.origin;
  }
  for (Skin& skin : model.skins) skin.bind_to_model = matrix * skin.bind_to_model;
  for (SkinnedMesh& mesh : model.meshes) turn_surface(mesh, glm::quat(turn));
  for (BakedMeshLod& lod : model.mesh_lods) {
    for (SkinnedMesh& mesh : lod.meshes) turn_surface(mesh, glm::quat(turn));
  }
}

void face_forward(Model& model) {
  if (!model.faces_backwards) return;
  turn_model(model, {0.0, 0.0, 1.0, 0.0});
  model.faces_backwards = false;
}

}  // namespace throng::anim
