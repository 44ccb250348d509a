#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/gl/doll_crowd.h"
#include "tests/gl/gl_test.h"
#include "tests/gl/picture_tolerance.h"

namespace throng::render::test::morphs_test {
namespace {

constexpr float share = 0.5F;          // the weight of morph 0
constexpr float other_share = -0.25F;  // of morph 4

/// A doll with five morphs: 0 moves all vertices aside and turns their normals, 4 lifts every third. `moved` is the
/// doll that they make of it.
struct MorphingDoll {
  explicit MorphingDoll(const Doll& doll) : plain(doll.mesh_data()), morphing(plain), moved(plain) {
    positions.assign(plain.parts[0].positions.begin(), plain.parts[0].positions.end());
    normals.assign(plain.parts[0].normals.begin(), plain.parts[0].normals.end());
    for (std::uint32_t vertex = 0; vertex < positions.size() / 3; ++vertex) {
      add({.vertex = vertex, .morph = 0, .position = {0.4F, 0.0F, 0.2F}, .normal = {0.3F, 0.0F, 0.6F}}, share);
      if (vertex % 3 == 0)
        add({.vertex = vertex, .morph = 4, .position = {0.0F, 0.2F, 0.0F}, .normal = {}}, other_share);
    }
    moved.parts[0].positions = positions;
    moved.parts[0].normals = normals;
  }

  void add(const MorphDeltaData& delta, float weight) {
    morphing.morph_deltas.push_back(delta);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      positions[delta.vertex * 3 + axis] += weight * delta.position[axis];
      normals[delta.vertex * 3 + axis] += weight * delta.normal[axis];
    }
  }

  std::vector<float> positions, normals;
  CrowdMeshData plain, morphing, moved;
};

class Morphs : public SoftwareGlTest {
 protected:
  void SetUp() override {
    SoftwareGlTest::SetUp();
    crowd_ = std::make_unique<DollCrowd>(context());
    crowd_->stand(15);
    crowd_->write_palettes();
    // The first four are of somebody else.
    weights_ = {9, 9, 9, 9, share, 9, 9, 9, other_share, 0, 0, 0};
  }
  void TearDown() override {
    crowd_.reset();
    SoftwareGlTest::TearDown();
  }

  DollCrowd& crowd() { return *crowd_; }
  void load(const CrowdMeshData& doll) {
    const std::vector<CrowdMeshData> dolls(2, doll);
    EXPECT_TRUE(crowd().renderer().load_characters(dolls));
  }
  void let_morph(InstanceRecord& record) const { record.weights = 5; }
  CrowdFrame frame() {
    CrowdFrame frame = crowd().frame();
    frame.morph_weights = weights_;
    return frame;
  }
  Image picture() {
    crowd().renderer().draw(frame());
    return crowd().renderer().read_image();
  }

 private:
  std::unique_ptr<DollCrowd> crowd_;
  std::vector<float> weights_;
};

double largest_distance(const std::vector<ReadBackVertex>& some, const std::vector<ReadBackVertex>& others) {
  EXPECT_EQ(some.size(), others.size());
  float largest = 0.0F;
  for (std::size_t i = 0; i < std::min(some.size(), others.size()); ++i) {
    largest = std::max({largest, glm::distance(some[i].position, others[i].position),
                        glm::distance(some[i].normal, others[i].normal)});
  }
  return static_cast<double>(largest);
}

TEST_F(Morphs, MoveVerticesBeforeThePaletteDoes) {
  const MorphingDoll doll(crowd().doll());
  load(doll.moved);
  const std::vector<ReadBackVertex> expected = crowd().read_back(frame(), 5);
  load(doll.morphing);
  let_morph(crowd().instances[5]);
  EXPECT_LT(largest_distance(crowd().read_back(frame(), 5), expected), 1e-5);
}

TEST_F(Morphs, LeaveInstancesAloneThatHaveNoWeights) {
  const MorphingDoll doll(crowd().doll());
  load(doll.plain);
  const std::vector<ReadBackVertex> expected = crowd().read_back(frame(), 6);
  load(doll.morphing);
  let_morph(crowd().instances[5]);
  EXPECT_EQ(largest_distance(crowd().read_back(frame(), 6), expected), 0.0);
}

/// Every program of the crowd, with its shadows.
TEST_F(Morphs, AreDrawnInEveryKindOfMaterial) {
  MaterialData glowing, cut_out, blended;
  glowing.emission[0] = 0.5F;
  cut_out.base_color[3] = 0.8F;
  cut_out.alpha_cutoff = 0.5F;
  blended.base_color[3] = 0.6F;
  blended.blended = true;
  MorphingDoll doll(crowd().doll());
  for (InstanceRecord& record : crowd().instances) record.contact_scale = 0.0F;
  for (const MaterialData& material : {MaterialData{}, glowing, cut_out, blended}) {
    for (CrowdMeshData* data : {&doll.plain, &doll.morphing, &doll.moved}) data->materials = {material};
    load(doll.moved);
    const Image expected = picture();
    load(doll.morphing);
    const Image rest = picture();
    for (InstanceRecord& record : crowd().instances) let_morph(record);
    const Image morphed = picture();
    for (InstanceRecord& record : crowd().instances) record.weights = 0;
    EXPECT_TRUE(looks_the_same(*measure_difference(expected, morphed)));
    EXPECT_FALSE(looks_the_same(*measure_difference(rest, morphed)));
  }
}

}  // namespace
}  // namespace throng::render::test::morphs_test
