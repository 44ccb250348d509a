#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include "engine/anim/kernel/kernels.h"
#include "tests/anim/kernel/pose/random_packet.h"
#include "tests/anim/kernel/validity.h"

namespace throng::anim::blend_test {
namespace {

glm::dquat reference_blend(const glm::dquat& from, glm::dquat to, double weight) {
  if (glm::dot(from, to) < 0.0) to = -to;
  return glm::normalize(from * (1.0 - weight) + to * weight);
}

Packet blend(const Kernels& kernels, const Packet& from, const Packet& to, float fraction,
             const float* bone_weights = nullptr, int components = general_components) {
  Packet out{};
  BlendJob job;
  job.from = from.lanes[0];
  job.to = to.lanes[0];
  job.bone_weights = bone_weights;
  job.fraction = fraction;
  job.components = components;
  job.out = out.lanes[0];
  kernels.blend(job);
  return out;
}

TEST(BlendJob, IsValidAsItsCommentsSay) {
  alignas(64) static constexpr float too_heavy[packet_bones] = {0.0F, 1.0F, 1.1F};
  alignas(64) const float weights[packet_bones] = {0.0F, 0.5F, 1.0F};
  const Packet from = random_packet(1), to = random_packet(2);
  Packet out{};
  const BlendJob job{.from = from.data(),
                     .to = to.data(),
                     .bone_weights = weights,
                     .fraction = 0.5F,
                     .components = general_components,
                     .out = out.data()};
  expect_validity<BlendJob>(job,
                            {{false, "no from", [](BlendJob& job) { job.from = nullptr; }},
                             {false, "from off the alignment", [](BlendJob& job) { job.from += 4; }},
                             {false, "no to", [](BlendJob& job) { job.to = nullptr; }},
                             {false, "to off the alignment", [](BlendJob& job) { job.to += 4; }},
                             {false, "no out", [](BlendJob& job) { job.out = nullptr; }},
                             {false, "out off the alignment", [](BlendJob& job) { job.out += 4; }},
                             {true, "no bone weights", [](BlendJob& job) { job.bone_weights = nullptr; }},
                             {false, "bone weights off the alignment", [](BlendJob& job) { job.bone_weights += 4; }},
                             {false, "a bone weight above 1", [](BlendJob& job) { job.bone_weights = too_heavy; }},
                             {true, "fraction 0", [](BlendJob& job) { job.fraction = 0.0F; }},
                             {true, "fraction 1", [](BlendJob& job) { job.fraction = 1.0F; }},
                             {false, "fraction below 0", [](BlendJob& job) { job.fraction = -0.01F; }},
                             {false, "fraction above 1", [](BlendJob& job) { job.fraction = 1.01F; }},
                             {false, "fraction not a number", [](BlendJob& job) { job.fraction = std::nanf(""); }},
                             {true, "rigid", [](BlendJob& job) { job.components = rigid_components; }},
                             {false, "eight components", [](BlendJob& job) { job.components = 8; }}});
}

TEST(Blend, AgreesWithDoublePrecisionOnEveryTarget) {
  for (const Kernels& kernels : runnable_kernels()) {
    for (unsigned seed = 0; seed < 100; ++seed) {
      const Packet from = random_packet(2 * seed);
      const Packet to = random_packet(2 * seed + 1);
      const float fraction = static_cast<float>(seed) / 99.0F;
      const Packet out = blend(kernels, from, to, fraction);
      for (int bone = 0; bone < packet_bones; ++bone) {
        const glm::dquat expected =
            reference_blend(rotation_of(from, bone), rotation_of(to, bone), static_cast<double>(fraction));
        const glm::dquat actual = rotation_of(out, bone);
        ASSERT_LT(glm::length(actual - expected), 2e-6) << kernels.target << " " << seed << " " << bone;
        for (int component = 4; component < general_components; ++component) {
          const float start = from.lanes[component][bone];
          const float end = to.lanes[component][bone];
          ASSERT_NEAR(out.lanes[component][bone], start + (end - start) * fraction, 1e-6F);
        }
      }
    }
  }
}

TEST(Blend, LeavesRotationsUnitToAMillionth) {
  for (const Kernels& kernels : runnable_kernels()) {
    for (unsigned seed = 0; seed < 200; ++seed) {
      const Packet out = blend(kernels, random_packet(seed), random_packet(seed + 1000), 0.5F);
      for (int bone = 0; bone < packet_bones; ++bone) {
        ASSERT_NEAR(glm::length(rotation_of(out, bone)), 1.0, 1e-6) << kernels.target;
      }
    }
  }
}

TEST(Blend, WeighsEveryBoneByItsOwnWeight) {
  alignas(64) float weights[packet_bones];
  for (int bone = 0; bone < packet_bones; ++bone) weights[bone] = static_cast<float>(bone) / 15.0F;
  const Packet from = random_packet(1);
  const Packet to = random_packet(2);
  for (const Kernels& kernels : runnable_kernels()) {
    const Packet out = blend(kernels, from, to, 0.8F, weights);
    for (int bone = 0; bone < packet_bones; ++bone) {
      const double weight = 0.8 * static_cast<double>(weights[bone]);
      EXPECT_LT(
          glm::length(rotation_of(out, bone) - reference_blend(rotation_of(from, bone), rotation_of(to, bone), weight)),
          2e-6)
          << kernels.target;
    }
  }
}

TEST(Blend, KeepsTheBitsOfABoneThatWeighsNothingAndTakesThoseOfOneThatWeighsAll) {
  alignas(64) float weights[packet_bones];
  for (int bone = 0; bone < packet_bones; ++bone) weights[bone] = bone % 2 == 0 ? 0.0F : 1.0F;
  for (const Kernels& kernels : runnable_kernels()) {
    for (unsigned seed = 0; seed < 50; ++seed) {
      const Packet from = random_packet(seed);
      const Packet to = random_packet(seed + 1000);
      Packet expected = from;
      for (int component = 0; component < general_components; ++component) {
        for (int bone = 1; bone < packet_bones; bone += 2) expected.lanes[component][bone] = to.lanes[component][bone];
      }
      EXPECT_EQ(bits(blend(kernels, from, to, 1.0F, weights)), bits(expected)) << kernels.target << " " << seed;
    }
  }
}

TEST(Blend, MayWriteOverEitherSource) {
  for (const Kernels& kernels : runnable_kernels()) {
    const Packet expected = blend(kernels, random_packet(5), random_packet(6), 0.3F);
    for (const bool over_from : {true, false}) {
      Packet from = random_packet(5);
      Packet to = random_packet(6);
      Packet& out = over_from ? from : to;
      BlendJob job;
      job.from = from.lanes[0];
      job.to = to.lanes[0];
      job.fraction = 0.3F;
      job.components = general_components;
      job.out = out.lanes[0];
      kernels.blend(job);
      EXPECT_EQ(bits(out), bits(expected)) << kernels.target << " " << over_from;
    }
  }
}

TEST(Blend, DoesNotTouchWhatTheStateHasNot) {
  for (const Kernels& kernels : runnable_kernels()) {
    const Packet out = blend(kernels, random_packet(5), random_packet(6), 0.3F, nullptr, rigid_components);
    for (int component = rigid_components; component < general_components; ++component) {
      for (const float value : out.lanes[component]) EXPECT_EQ(value, 0.0F) << kernels.target;
    }
  }
}

TEST(Blend, IsTheSameToTheBitAmongTargetsThatFuse) {
  const Packet from = random_packet(11);
  const Packet to = random_packet(12);
  const Packet best = blend(best_kernels(), from, to, 0.7F);
  for (const Kernels& kernels : runnable_kernels()) {
    if (kernels.fused_multiply_add != best_kernels().fused_multiply_add) continue;
    const Packet out = blend(kernels, from, to, 0.7F);
    EXPECT_EQ(bits(out), bits(best)) << kernels.target;
  }
}

}  // namespace
}  // namespace throng::anim::blend_test
