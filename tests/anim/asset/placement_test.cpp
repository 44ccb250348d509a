#include "engine/anim/asset/placement.h"

#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/character.h"

namespace throng::anim::placement_test {
namespace {

const Placement placement{
    .scale = 0.01, .rotation = glm::angleAxis(0.7, glm::dvec3(0.0, 1.0, 0.0)), .offset = {3, -1, 2}};

/// A skeleton on the general path that does what `rigid` does.
Model as_general(Model rigid) {
  Skeleton& skeleton = rigid.skeleton;
  skeleton.rigid = false;
  for (PaletteEntry& entry : skeleton.palette) {
    const ReferenceFrame& frame = skeleton.references[static_cast<std::size_t>(entry.bone)];
    entry.post =
        glm::inverse(compose({.rotation = frame.rotation, .position = frame.origin, .scale = glm::dvec3(frame.scale)}));
  }
  skeleton.references.assign(skeleton.bones.size(), {});
  return rigid;
}

/// Returns where the joints and a vertex beside each are, in the space of the model.
std::vector<glm::dvec3> places_of(const Model& model) {
  const ReferencePose pose = reference_pose(model.skeleton, &model.clips.front(), 0.37);
  std::vector<glm::dvec3> places;
  for (const glm::dmat4& global : pose.globals) places.emplace_back(global[3]);
  for (const SkinnedMesh& mesh : model.meshes) {
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      places.emplace_back(pose.palette[mesh.palette_entries[v].x] * glm::dvec4(glm::dvec3(mesh.positions[v]), 1.0));
    }
  }
  return places;
}

Model with_vertices(Model model) {
  SkinnedMesh mesh;
  for (int bone = 0; bone < model.skeleton.bone_count(); ++bone) {
    mesh.positions.emplace_back(0.1F * static_cast<float>(bone), 1.0F, 0.5F);
    mesh.normals.emplace_back(0.0F, 0.0F, 1.0F);
    mesh.palette_entries.emplace_back(bone, 0, 0, 0);
    mesh.weights.emplace_back(1.0F, 0.0F, 0.0F, 0.0F);
  }
  model.meshes.push_back(mesh);
  return model;
}

void expect_moved(const Model& model) {
  Model moved = model;
  place_model(moved, placement);
  const std::vector<glm::dvec3> before = places_of(model), after = places_of(moved);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const glm::dvec3 expected = placement.offset + placement.rotation * (placement.scale * before[i]);
    EXPECT_LT(glm::distance(after[i], expected), 1e-6) << i;
  }
}

TEST(Placement, MovesEveryPoseAndTheSurfaceOfARigidSkeleton) { expect_moved(with_vertices(synthetic_model(30, 1))); }

TEST(Placement, MovesEveryPoseAndTheSurfaceOfAGeneralSkeleton) {
  expect_moved(with_vertices(as_general(synthetic_model(30, 1))));
}

TEST(Placement, ScalesAndTurnsWhatMorphsAddToARigidSurface) {
  Model model = with_vertices(synthetic_model(4, 1));
  const MorphDelta delta{.vertex = 2, .morph = 0, .position = {10.0F, 20.0F, 30.0F}, .normal = {0.5F, 0.0F, 0.0F}};
  model.meshes.front().morph_deltas = {delta};
  Model general = as_general(model);
  place_model(model, placement);
  const MorphDelta& moved = model.meshes.front().morph_deltas.front();
  const glm::dvec3 position = placement.rotation * (placement.scale * glm::dvec3(delta.position));
  EXPECT_LT(glm::distance(glm::dvec3(moved.position), position), 1e-6);
  EXPECT_LT(glm::distance(glm::dvec3(moved.normal), placement.rotation * glm::dvec3(delta.normal)), 1e-6);
  place_model(general, placement);
  EXPECT_EQ(general.meshes.front().morph_deltas.front().position, delta.position) << "its palette does that";
}

TEST(Placement, KeepsWhatAStateMeansOnARigidSkeleton) {
  Model model = synthetic_model(30, 1);
  place_model(model, placement);
  for (int bone = 0; bone < model.skeleton.bone_count(); ++bone) {
    const StateTransform local = rest_transform(model.skeleton.bones[static_cast<std::size_t>(bone)]);
    const StateTransform back = to_local(model.skeleton, bone, to_state(model.skeleton, bone, local));
    EXPECT_LT(glm::distance(back.position, local.position), 1e-9) << bone;
  }
}

TEST(Placement, ScalesRootMotionAndTurnsIt) {
  Model model = synthetic_model(8, 1);
  Track<glm::vec3>& track = model.clips.front().tracks.front().translation;
  track = {.times = {0.0F, static_cast<float>(model.clips.front().duration)},
           .values = {{0.0F, 100.0F, 0.0F}, {0.0F, 100.0F, 120.0F}}};
  model.skeleton.bones.front().rest.translation = {0.0F, 100.0F, 0.0F};
  const Placement turned{.scale = 0.01, .rotation = glm::angleAxis(glm::radians(90.0), glm::dvec3(0.0, 1.0, 0.0))};
  place_model(model, turned);
  const Character character = bake_character(model);
  EXPECT_LT(glm::distance(character.clips.front().loop_displacement, glm::dvec3(1.2, 0.0, 0.0)), 1e-4);
}

TEST(FaceForward, TurnsPosesAndSurfaceByHalfATurnAndSaysSo) {
  for (const Model& model :
       {with_vertices(synthetic_model(20, 1)), with_vertices(as_general(synthetic_model(20, 1)))}) {
    ImportedFile file;
    file.models = {model};
    file.models.front().faces_backwards = true;
    face_forward(file);
    EXPECT_FALSE(file.models.front().faces_backwards);
    EXPECT_EQ(file.notes.size(), 1U);
    const std::vector<glm::dvec3> before = places_of(model), after = places_of(file.models.front());
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_LT(glm::distance(after[i], glm::dvec3(-before[i].x, before[i].y, -before[i].z)), 1e-6) << i;
    }
  }
}

TEST(FaceForward, LeavesAModelThatFacesForward) {
  ImportedFile file;
  file.models = {synthetic_model(5, 1)};
  face_forward(file);
  EXPECT_EQ(file.models.front().skeleton.bones.front().prefix, glm::dmat4(1.0));
  EXPECT_TRUE(file.notes.empty());
}

}  // namespace
}  // namespace throng::anim::placement_test
