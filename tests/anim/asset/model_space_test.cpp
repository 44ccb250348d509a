#include "engine/anim/asset/model_space.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim::model_space_test {
namespace {

TEST(FaceForward, TurnsEveryPoseByHalfATurn) {
  for (const bool rigid : {true, false}) {
    Model model = synthetic_model(20, 1);
    model.skeleton.rigid = rigid;
    const Model before = model;
    model.faces_backwards = true;
    face_forward(model);
    const double seconds = 0.4 * model.clips.front().duration;
    const ReferencePose expected = reference_pose(before.skeleton, &before.clips.front(), seconds);
    const ReferencePose turned = reference_pose(model.skeleton, &model.clips.front(), seconds);
    for (std::size_t bone = 0; bone < expected.globals.size(); ++bone) {
      const glm::dvec3 place(expected.globals[bone][3]);
      EXPECT_LT(glm::distance(glm::dvec3(turned.globals[bone][3]), glm::dvec3(-place.x, place.y, -place.z)), 1e-9);
    }
  }
}

TEST(FaceForward, TurnsTheSurfaceWithTheBones) {
  Model model = synthetic_model(20, 1);
  const Model before = model;
  SkinnedMesh& mesh = model.meshes.emplace_back();
  mesh.positions = {{0.1F, 0.2F, 0.3F}};
  mesh.normals = {{0.0F, 0.0F, 1.0F}};
  model.faces_backwards = true;
  face_forward(model);
  EXPECT_FALSE(model.faces_backwards);
  const double seconds = 0.4 * model.clips.front().duration;
  const glm::dvec4 vertex(0.1, 0.2, 0.3, 1.0);
  const glm::dvec4 expected = reference_pose(before.skeleton, &before.clips.front(), seconds).palette[3] * vertex;
  const glm::dvec4 shown = reference_pose(model.skeleton, &model.clips.front(), seconds).palette[3] *
                           glm::dvec4(model.meshes.front().positions.front(), 1.0);
  EXPECT_LT(glm::distance(glm::dvec3(shown), glm::dvec3(-expected.x, expected.y, -expected.z)), 1e-6);
  EXPECT_LT(glm::distance(model.meshes.front().normals.front(), glm::vec3(0.0F, 0.0F, -1.0F)), 1e-6F);
}

TEST(FaceForward, LeavesAModelThatFacesForward) {
  Model model = synthetic_model(5, 1);
  face_forward(model);
  EXPECT_EQ(model.skeleton.bones.front().prefix, glm::dmat4(1.0));
}

}  // namespace
}  // namespace throng::anim::model_space_test
