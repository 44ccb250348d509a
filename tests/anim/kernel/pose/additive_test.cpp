#include <cmath>

#include <gtest/gtest.h>

#include "engine/anim/kernel/kernels.h"
#include "tests/anim/kernel/pose/random_packet.h"
#include "tests/anim/kernel/validity.h"

namespace throng::anim::additive_test {
namespace {

Packet add(const Kernels& kernels, const Packet& base, const Packet& delta, float weight,
           const float* bone_weights = nullptr, int components = general_components) {
  Packet out{};
  kernels.add({.base = base.data(),
               .delta = delta.data(),
               .bone_weights = bone_weights,
               .weight = weight,
               .components = components,
               .out = out.data()});
  return out;
}

Packet subtract(const Kernels& kernels, const Packet& pose, const Packet& reference,
                int components = general_components) {
  Packet out{};
  kernels.subtract({.pose = pose.data(), .reference = reference.data(), .components = components, .out = out.data()});
  return out;
}

glm::dquat reference_sum(const glm::dquat& base, glm::dquat delta, double weight) {
  if (delta.w < 0.0) delta = -delta;
  return base * glm::normalize(glm::dquat(1.0, 0.0, 0.0, 0.0) * (1.0 - weight) + delta * weight);
}

void expect_reference_sum(const Packet& out, const Packet& base, const Packet& delta, int bone, double weight) {
  const glm::dquat rotation = reference_sum(rotation_of(base, bone), rotation_of(delta, bone), weight);
  EXPECT_LT(glm::length(rotation_of(out, bone) - rotation), 2e-6);
  EXPECT_LT(glm::length(position_of(out, bone) - position_of(base, bone) - position_of(delta, bone) * weight), 1e-6);
  const glm::dvec3 factor = glm::dvec3(1.0) + (scale_of(delta, bone) - glm::dvec3(1.0)) * weight;
  EXPECT_LT(glm::length(scale_of(out, bone) - scale_of(base, bone) * factor), 1e-6);
}

TEST(AddJob, IsValidAsItsCommentsSay) {
  alignas(64) static constexpr float too_heavy[packet_bones] = {0.0F, 1.0F, 1.1F};
  alignas(64) const float weights[packet_bones] = {0.0F, 0.5F, 1.0F};
  const Packet base = random_packet(1), delta = random_packet(2);
  Packet out{};
  const AddJob job{.base = base.data(),
                   .delta = delta.data(),
                   .bone_weights = weights,
                   .weight = 0.5F,
                   .components = general_components,
                   .out = out.data()};
  expect_validity<AddJob>(job, {{false, "no base", [](AddJob& job) { job.base = nullptr; }},
                                {false, "base off the alignment", [](AddJob& job) { job.base += 4; }},
                                {false, "no delta", [](AddJob& job) { job.delta = nullptr; }},
                                {false, "delta off the alignment", [](AddJob& job) { job.delta += 4; }},
                                {false, "no out", [](AddJob& job) { job.out = nullptr; }},
                                {false, "out off the alignment", [](AddJob& job) { job.out += 4; }},
                                {true, "no bone weights", [](AddJob& job) { job.bone_weights = nullptr; }},
                                {false, "bone weights off the alignment", [](AddJob& job) { job.bone_weights += 4; }},
                                {false, "a bone weight above 1", [](AddJob& job) { job.bone_weights = too_heavy; }},
                                {true, "weight 0", [](AddJob& job) { job.weight = 0.0F; }},
                                {true, "weight 1", [](AddJob& job) { job.weight = 1.0F; }},
                                {false, "weight below 0", [](AddJob& job) { job.weight = -0.01F; }},
                                {false, "weight above 1", [](AddJob& job) { job.weight = 1.01F; }},
                                {false, "weight not a number", [](AddJob& job) { job.weight = std::nanf(""); }},
                                {true, "rigid", [](AddJob& job) { job.components = rigid_components; }},
                                {false, "eight components", [](AddJob& job) { job.components = 8; }}});
}

TEST(SubtractJob, IsValidAsItsCommentsSay) {
  const Packet pose = random_packet(1), reference = random_packet(2);
  Packet out{};
  const SubtractJob job{
      .pose = pose.data(), .reference = reference.data(), .components = general_components, .out = out.data()};
  expect_validity<SubtractJob>(job,
                               {{false, "no pose", [](SubtractJob& job) { job.pose = nullptr; }},
                                {false, "pose off the alignment", [](SubtractJob& job) { job.pose += 4; }},
                                {false, "no reference", [](SubtractJob& job) { job.reference = nullptr; }},
                                {false, "reference off the alignment", [](SubtractJob& job) { job.reference += 4; }},
                                {false, "no out", [](SubtractJob& job) { job.out = nullptr; }},
                                {false, "out off the alignment", [](SubtractJob& job) { job.out += 4; }},
                                {true, "rigid", [](SubtractJob& job) { job.components = rigid_components; }},
                                {false, "eight components", [](SubtractJob& job) { job.components = 8; }}});
}

TEST(Add, AgreesWithDoublePrecisionOnEveryTarget) {
  for (const Kernels& kernels : runnable_kernels()) {
    SCOPED_TRACE(kernels.target);
    for (unsigned seed = 0; seed < 50; ++seed) {
      const Packet base = random_packet(2 * seed);
      const Packet delta = random_packet(2 * seed + 1);
      const float weight = static_cast<float>(seed) / 49.0F;
      const Packet out = add(kernels, base, delta, weight);
      for (int bone = 0; bone < packet_bones; ++bone) {
        expect_reference_sum(out, base, delta, bone, static_cast<double>(weight));
        EXPECT_NEAR(glm::length(rotation_of(out, bone)), 1.0, 1e-6);
      }
    }
  }
}

TEST(Add, WeighsEveryBoneByItsOwnWeight) {
  alignas(64) float weights[packet_bones];
  for (int bone = 0; bone < packet_bones; ++bone) weights[bone] = static_cast<float>(bone) / 15.0F;
  const Packet base = random_packet(1);
  const Packet delta = random_packet(2);
  for (const Kernels& kernels : runnable_kernels()) {
    SCOPED_TRACE(kernels.target);
    const Packet out = add(kernels, base, delta, 0.8F, weights);
    for (int bone = 0; bone < packet_bones; ++bone) {
      expect_reference_sum(out, base, delta, bone, 0.8 * static_cast<double>(weights[bone]));
    }
  }
}

TEST(Add, KeepsTheBitsOfABoneThatWeighsNothing) {
  alignas(64) float weights[packet_bones];
  for (int bone = 0; bone < packet_bones; ++bone) weights[bone] = bone % 2 == 0 ? 0.0F : 1.0F;
  for (const Kernels& kernels : runnable_kernels()) {
    const Packet delta = random_packet(2);
    for (const Packet& base : {random_packet(1), identity_packet()}) {
      const Packet masked = add(kernels, base, delta, 1.0F, weights);
      for (int bone = 0; bone < packet_bones; bone += 2) {
        EXPECT_EQ(bone_bits(masked, bone), bone_bits(base, bone)) << kernels.target;
      }
      EXPECT_EQ(bits(add(kernels, base, delta, 0.0F)), bits(base)) << kernels.target;
    }
  }
}

TEST(Add, TakesADeltaTheShortWayRound) {
  const Packet base = random_packet(1);
  Packet delta = identity_packet();
  for (int bone = 0; bone < packet_bones; ++bone) set_rotation(delta, bone, -rotation_by({0.0, 0.4, 0.0}));
  for (const Kernels& kernels : runnable_kernels()) {
    const Packet out = add(kernels, base, delta, 0.5F);
    for (int bone = 0; bone < packet_bones; ++bone) {
      EXPECT_NEAR(angle_between(rotation_of(base, bone), rotation_of(out, bone)), 0.2, 1e-5) << kernels.target;
    }
  }
}

TEST(Subtract, AgreesWithDoublePrecisionOnEveryTarget) {
  for (const Kernels& kernels : runnable_kernels()) {
    for (unsigned seed = 0; seed < 50; ++seed) {
      const Packet pose = random_packet(2 * seed);
      Packet reference = random_packet(2 * seed + 1);
      for (int component = rigid_components; component < general_components; ++component) {
        for (float& scale : reference.lanes[component]) scale = std::copysign(0.5F + std::abs(scale), scale);
      }
      const Packet out = subtract(kernels, pose, reference);
      for (int bone = 0; bone < packet_bones; ++bone) {
        const glm::dquat expected = glm::conjugate(rotation_of(reference, bone)) * rotation_of(pose, bone);
        EXPECT_GE(rotation_of(out, bone).w, 0.0) << kernels.target;
        EXPECT_LT(angle_between(rotation_of(out, bone), expected), 2e-6) << kernels.target;
        EXPECT_NEAR(glm::length(rotation_of(out, bone)), 1.0, 1e-6) << kernels.target;
        EXPECT_LT(glm::length(position_of(out, bone) - (position_of(pose, bone) - position_of(reference, bone))), 1e-6);
        EXPECT_LT(glm::length(scale_of(out, bone) - scale_of(pose, bone) / scale_of(reference, bone)), 1e-6);
      }
    }
  }
}

TEST(Subtract, GivesWhatAddingToTheReferenceTurnsBackIntoThePose) {
  for (const Kernels& kernels : runnable_kernels()) {
    for (unsigned seed = 0; seed < 50; ++seed) {
      const Packet pose = random_packet(seed);
      const Packet reference = random_packet(seed + 1000);
      const Packet back = add(kernels, reference, subtract(kernels, pose, reference), 1.0F);
      for (int bone = 0; bone < packet_bones; ++bone) {
        EXPECT_LT(angle_between(rotation_of(back, bone), rotation_of(pose, bone)), 3e-6) << kernels.target;
        EXPECT_LT(glm::length(position_of(back, bone) - position_of(pose, bone)), 1e-6) << kernels.target;
        EXPECT_LT(glm::length(scale_of(back, bone) - scale_of(pose, bone)), 2e-6) << kernels.target;
      }
    }
  }
}

TEST(Subtract, FindsNoDifferenceBetweenAPoseAndItself) {
  for (const Kernels& kernels : runnable_kernels()) {
    const Packet delta = subtract(kernels, random_packet(3), random_packet(3));
    for (int bone = 0; bone < packet_bones; ++bone) {
      EXPECT_LT(angle_between(rotation_of(delta, bone), {1.0, 0.0, 0.0, 0.0}), 1e-6) << kernels.target;
      EXPECT_EQ(position_of(delta, bone), glm::dvec3(0.0)) << kernels.target;
      EXPECT_EQ(scale_of(delta, bone), glm::dvec3(1.0)) << kernels.target;
    }
  }
}

TEST(Subtract, CallsAScaleThatTheReferenceHasNotUnchanged) {
  Packet reference = random_packet(4);
  reference.lanes[8][5] = 0.0F;
  for (const Kernels& kernels : runnable_kernels()) {
    EXPECT_EQ(subtract(kernels, random_packet(3), reference).lanes[8][5], 1.0F) << kernels.target;
  }
}

TEST(Additive, MayWriteOverEitherInput) {
  for (const Kernels& kernels : runnable_kernels()) {
    for (const bool over_first : {true, false}) {
      Packet first = random_packet(5);
      Packet second = random_packet(6);
      const Packet sum = add(kernels, first, second, 0.3F);
      Packet& out = over_first ? first : second;
      kernels.add({.base = first.data(),
                   .delta = second.data(),
                   .weight = 0.3F,
                   .components = general_components,
                   .out = out.data()});
      EXPECT_EQ(bits(out), bits(sum)) << kernels.target << " " << over_first;

      first = random_packet(5);
      second = random_packet(6);
      const Packet delta = subtract(kernels, first, second);
      kernels.subtract(
          {.pose = first.data(), .reference = second.data(), .components = general_components, .out = out.data()});
      EXPECT_EQ(bits(out), bits(delta)) << kernels.target << " " << over_first;
    }
  }
}

TEST(Additive, DoesNotTouchWhatTheStateHasNot) {
  for (const Kernels& kernels : runnable_kernels()) {
    const Packet sum = add(kernels, random_packet(5), random_packet(6), 0.3F, nullptr, rigid_components);
    const Packet delta = subtract(kernels, random_packet(5), random_packet(6), rigid_components);
    for (int component = rigid_components; component < general_components; ++component) {
      for (int bone = 0; bone < packet_bones; ++bone) {
        EXPECT_EQ(sum.lanes[component][bone], 0.0F) << kernels.target;
        EXPECT_EQ(delta.lanes[component][bone], 0.0F) << kernels.target;
      }
    }
  }
}

TEST(Additive, IsTheSameToTheBitAmongTargetsThatFuse) {
  const Packet pose = random_packet(11);
  const Packet reference = random_packet(12);
  const Packet best_delta = subtract(best_kernels(), pose, reference);
  const Packet best_sum = add(best_kernels(), pose, best_delta, 0.7F);
  for (const Kernels& kernels : runnable_kernels()) {
    if (kernels.fused_multiply_add != best_kernels().fused_multiply_add) continue;
    EXPECT_EQ(bits(subtract(kernels, pose, reference)), bits(best_delta)) << kernels.target;
    EXPECT_EQ(bits(add(kernels, pose, best_delta, 0.7F)), bits(best_sum)) << kernels.target;
  }
}

}  // namespace
}  // namespace throng::anim::additive_test
