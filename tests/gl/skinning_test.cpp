#include <algorithm>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/gl/doll_crowd.h"
#include "tests/gl/gl_test.h"

namespace throng::render::test::skinning_test {
namespace {

constexpr double third = 1.0 / 3.0;
constexpr double tolerance = 1e-4;  // metres

glm::dvec3 turned(const InstanceRecord& record, const glm::dvec3& v) {
  const auto cosine = static_cast<double>(record.heading_cosine), sine = static_cast<double>(record.heading_sine);
  return {cosine * v.x + sine * v.z, v.y, cosine * v.z - sine * v.x};
}

/// Measures, in metres, how far the shader's surface of `agent` is from the CPU's with the share `blend` of `to`.
double largest_error(DollCrowd& crowd, std::uint32_t agent, const DollPalette& from, const DollPalette& to,
                     double blend) {
  const std::vector<ReadBackVertex> drawn = crowd.read_back(crowd.frame(), agent);
  EXPECT_EQ(drawn.size(), crowd.doll().vertex_count());
  const InstanceRecord& record = crowd.instances[agent];
  const glm::dvec3 place(record.position[0], record.position[1], record.position[2]);
  double largest = 0.0;
  for (std::size_t vertex = 0; vertex < drawn.size(); ++vertex) {
    const glm::dvec3 position =
        glm::mix(crowd.doll().skinned_position(vertex, from), crowd.doll().skinned_position(vertex, to), blend);
    const glm::dvec3 world = place + static_cast<double>(record.scale) * turned(record, position);
    const glm::dvec3 normal = turned(
        record, glm::mix(crowd.doll().skinned_normal(vertex, from), crowd.doll().skinned_normal(vertex, to), blend));
    largest = std::max({largest, glm::distance(world, glm::dvec3(drawn[vertex].position)),
                        glm::distance(normal, glm::dvec3(drawn[vertex].normal))});
  }
  return largest;
}

class Skinning : public SoftwareGlTest {
 protected:
  void SetUp() override {
    SoftwareGlTest::SetUp();
    crowd_ = std::make_unique<DollCrowd>(context());
    crowd_->stand(20);
  }
  void TearDown() override {
    crowd_.reset();
    SoftwareGlTest::TearDown();
  }

  DollCrowd& crowd() { return *crowd_; }
  double error_of(std::uint32_t agent) {
    return largest_error(crowd(), agent, crowd().from[agent], crowd().to[agent], third);
  }

 private:
  std::unique_ptr<DollCrowd> crowd_;
};

TEST_F(Skinning, PutsFirstSeventeenthAndLastAgentWhereTheProcessorPutsThem) {
  crowd().write_palettes();
  for (const std::uint32_t agent : {0U, 16U, 19U}) EXPECT_LT(error_of(agent), tolerance) << agent;
}

TEST_F(Skinning, ShowsOneSlotAloneAtEitherEndOfABlend) {
  crowd().write_palettes();
  const DollPalette &from = crowd().from[3], &to = crowd().to[3];
  InstanceRecord& record = crowd().instances[3];
  record.blend_start = DollCrowd::now;
  EXPECT_LT(largest_error(crowd(), 3, from, to, 0.0), tolerance);
  record.blend_start = DollCrowd::now - record.blend_duration;
  EXPECT_LT(largest_error(crowd(), 3, from, to, 1.0), tolerance);
  record.blend_duration = 0;
  record.blend_start = DollCrowd::now;
  EXPECT_LT(largest_error(crowd(), 3, from, to, 1.0), tolerance);
}

TEST_F(Skinning, BlendsAcrossTheWrapOfTheClock) {
  crowd().write_palettes();
  InstanceRecord& record = crowd().instances[0];
  CrowdFrame frame = crowd().frame();
  record.blend_start = UINT32_MAX - 9'999;
  record.blend_duration = 40'000;
  frame.now = 10'000;
  const std::vector<ReadBackVertex> drawn = crowd().read_back(frame, 0);
  record.blend_start = DollCrowd::now - 20'000;
  const std::vector<ReadBackVertex> expected = crowd().read_back(crowd().frame(), 0);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    EXPECT_LT(glm::distance(drawn[i].position, expected[i].position), 1e-6F) << i;
  }
}

TEST_F(Skinning, LowerBoneLevelFollowsTheNearestKeptJoint) {
  for (DollPalette* palette : {&crowd().from[5], &crowd().to[5]}) {
    for (const DollJoint dropped : {head, left_arm, right_arm}) (*palette)[dropped] = (*palette)[chest];
  }
  const DollPalette from = crowd().from[5], to = crowd().to[5];
  // Vertices of the lower level must not read the entries of dropped joints.
  for (const DollJoint dropped : {head, left_arm, right_arm}) crowd().to[5][dropped] = crowd().to[5][legs];
  crowd().write_palettes();
  crowd().instances[5].bone_level = 1;
  const std::vector<ReadBackVertex> drawn = crowd().read_back(crowd().frame(), 5);
  crowd().instances[5].bone_level = 0;
  crowd().from[5] = from;
  crowd().to[5] = to;
  crowd().write_palettes();
  const std::vector<ReadBackVertex> expected = crowd().read_back(crowd().frame(), 5);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    EXPECT_LT(glm::distance(drawn[i].position, expected[i].position), 1e-5F) << i;
  }
}

}  // namespace
}  // namespace throng::render::test::skinning_test
