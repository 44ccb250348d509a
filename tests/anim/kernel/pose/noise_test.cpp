#include "engine/anim/kernel/pose/noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/kernel/kernels.h"
#include "engine/base/hash.h"
#include "tests/anim/kernel/pose/random_packet.h"
#include "tests/anim/kernel/validity.h"

namespace throng::anim::noise_test {
namespace {

struct alignas(64) Amplitudes {
  float of[packet_bones];
};

Amplitudes even_amplitudes(float radians) {
  Amplitudes amplitudes{};
  std::fill(std::begin(amplitudes.of), std::end(amplitudes.of), radians);
  return amplitudes;
}

struct Noise {
  Amplitudes amplitudes = even_amplitudes(0.1F);
  NoisePoint point;
  std::uint64_t seed = 17;
  int packet = 2;
  float largest_amplitude = std::numbers::pi_v<float>;
  int bone_count = 5 * packet_bones;
};

void add_noise(const Kernels& kernels, const Packet& from, const Noise& noise, Packet& out,
               int components = general_components) {
  Amplitudes shares{};
  for (int bone = 0; bone < packet_bones; ++bone) shares.of[bone] = noise.amplitudes.of[bone] / noise.largest_amplitude;
  const NoiseMoment moment = noise_moment(noise.seed, noise.point, noise.largest_amplitude);
  const ShakenBones bones{.from = from.data(), .out = out.data(), .moment = &moment, .bone_weights = shares.of};
  kernels.noise(
      {.characters = {&bones, 1}, .packet = noise.packet, .bone_count = noise.bone_count, .components = components});
}

Packet with_noise(const Kernels& kernels, const Packet& from, const Noise& noise) {
  Packet out{};
  add_noise(kernels, from, noise, out);
  return out;
}

/// The rotation that the noise adds to a bone of the best kernels.
glm::dvec3 turn_at(const Noise& noise, int bone) {
  return rotation_vector(rotation_of(with_noise(best_kernels(), identity_packet(), noise), bone));
}

std::uint32_t mixed(std::uint32_t bits) {
  bits = (bits ^ (bits >> 16)) * 0x7FEB352DU;
  return bits ^ (bits >> 16);
}

double lattice_value(const Noise& noise, int axis, std::int64_t point, int bone) {
  const std::uint64_t key = chain_hash(noise.seed, static_cast<std::uint64_t>(point));
  const auto number = static_cast<std::uint32_t>(noise.packet * packet_bones + bone);
  const std::uint32_t bits = mixed((number * 0x9E3779B9U) ^ static_cast<std::uint32_t>(key)) << (10 * axis);
  return static_cast<double>(static_cast<std::int32_t>(bits)) * 0x1p-31;
}

/// The rotation vector: twice the arc tangent of half of what the spline makes of the axes' values.
glm::dvec3 reference_turn(const Noise& noise, int bone) {
  const auto t = static_cast<double>(noise.point.fraction);
  glm::dvec3 turn(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const auto value = [&](int step) { return lattice_value(noise, axis, noise.point.lattice + step, bone); };
    turn[axis] = value(0) * 0.5 * (1 - t) * (1 - t) + value(1) * (0.5 + t - t * t) + value(2) * 0.5 * t * t;
  }
  const glm::dvec3 half = turn * static_cast<double>(noise.amplitudes.of[bone]) / std::sqrt(12.0);
  const double tangent = glm::length(half);
  return tangent > 0.0 ? half * (2.0 * std::atan(tangent) / tangent) : glm::dvec3(0.0);
}

/// One character of a noise job, and jobs of it that differ in one thing.
struct Shaken {
  alignas(64) static constexpr float too_heavy[packet_bones] = {1.1F};
  static inline Packet packet = random_packet(1);
  static inline const NoiseMoment moment = noise_moment(17, {}, 0.1F), beyond_half_a_turn = noise_moment(17, {}, 3.2F);
  static inline const ShakenBones right{packet.data(), packet.data(), &moment, nullptr};
  static inline const ShakenBones from_nowhere{nullptr, packet.data(), &moment, nullptr};
  static inline const ShakenBones to_nowhere{packet.data(), nullptr, &moment, nullptr};
  static inline const ShakenBones off_the_alignment{packet.data(), packet.data() + 4, &moment, nullptr};
  static inline const ShakenBones at_no_moment{packet.data(), packet.data(), nullptr, nullptr};
  static inline const ShakenBones too_far{packet.data(), packet.data(), &beyond_half_a_turn, nullptr};
  static inline const ShakenBones weighed_above_one{packet.data(), packet.data(), &moment, too_heavy};
};

TEST(NoiseJob, IsValidAsItsCommentsSay) {
  const NoiseJob job{
      .characters = {&Shaken::right, 1}, .packet = 1, .bone_count = 20, .components = general_components};
  expect_validity<NoiseJob>(job, {{true, "nobody", [](NoiseJob& job) { job.characters = {}; }},
                                  {false, "no pose",
                                   [](NoiseJob& job) {
                                     job.characters = {&Shaken::from_nowhere, 1};
                                   }},
                                  {false, "no way out",
                                   [](NoiseJob& job) {
                                     job.characters = {&Shaken::to_nowhere, 1};
                                   }},
                                  {false, "a pose off the alignment",
                                   [](NoiseJob& job) {
                                     job.characters = {&Shaken::off_the_alignment, 1};
                                   }},
                                  {false, "no moment",
                                   [](NoiseJob& job) {
                                     job.characters = {&Shaken::at_no_moment, 1};
                                   }},
                                  {false, "an amplitude of more than half a turn",
                                   [](NoiseJob& job) {
                                     job.characters = {&Shaken::too_far, 1};
                                   }},
                                  {false, "a bone weight above 1",
                                   [](NoiseJob& job) {
                                     job.characters = {&Shaken::weighed_above_one, 1};
                                   }},
                                  {false, "a negative packet", [](NoiseJob& job) { job.packet = -1; }},
                                  {false, "a negative bone count", [](NoiseJob& job) { job.bone_count = -1; }},
                                  {true, "rigid", [](NoiseJob& job) { job.components = rigid_components; }},
                                  {false, "eight components", [](NoiseJob& job) { job.components = 8; }}});
}

TEST(Noise, AgreesWithDoublePrecisionOnEveryTarget) {
  for (const Kernels& kernels : runnable_kernels()) {
    for (unsigned seed = 0; seed < 60; ++seed) {
      Noise noise{.amplitudes = even_amplitudes(static_cast<float>(seed) * 0.05F),
                  .point = {static_cast<std::int64_t>(seed) * 977 - 9000, static_cast<float>(seed) / 59.0F},
                  .seed = seed};
      noise.packet = static_cast<int>(seed % 5);
      if (seed <= 6) noise.largest_amplitude = 0.3F;
      const Packet from = random_packet(seed);
      const Packet out = with_noise(kernels, from, noise);
      for (int bone = 0; bone < packet_bones; ++bone) {
        const glm::dquat expected = rotation_of(from, bone) * rotation_by(reference_turn(noise, bone));
        EXPECT_LT(glm::length(rotation_of(out, bone) - expected), 1e-6) << kernels.target << " " << seed;
      }
    }
  }
}

TEST(Noise, NeverTurnsABoneByMoreThanItsAmplitudeAndUsesMuchOfIt) {
  double largest = 0.0;
  for (std::int64_t point = 0; point < 2000; ++point) {
    const Noise noise{.amplitudes = even_amplitudes(0.5F), .point = {point, 0.5F}};
    for (int bone = 0; bone < packet_bones; ++bone) {
      const double turn = glm::length(turn_at(noise, bone));
      EXPECT_LE(turn, 0.5);
      largest = std::max(largest, turn);
    }
  }
  EXPECT_GT(largest, 0.4);
}

TEST(Noise, HasNoJumpsInValueOrVelocity) {
  // Across five lattice points of 4 Hz, 10,000 steps a second: a velocity changes little from step to step.
  constexpr float frequency = 4.0F;
  constexpr Ticks step = ticks_per_second / 10000;
  constexpr double seconds = 1e-4;
  glm::dvec3 before = turn_at({.amplitudes = even_amplitudes(1.0F), .point = noise_at(-step, frequency)}, 3);
  glm::dvec3 now = turn_at({.amplitudes = even_amplitudes(1.0F), .point = noise_at(Ticks{}, frequency)}, 3);
  for (int i = 1; i < 12500; ++i) {
    const glm::dvec3 next = turn_at({.amplitudes = even_amplitudes(1.0F), .point = noise_at(i * step, frequency)}, 3);
    ASSERT_LT(glm::length(next - now), 8.0 * seconds) << i;
    // The second derivative is at most 4 times the frequency squared; the rest is rounding.
    ASSERT_LT(glm::length(next - 2.0 * now + before), 64.0 * seconds * seconds + 1e-6) << i;
    before = now;
    now = next;
  }
}

TEST(Noise, IsAsExactAfterAYearAsAtFirst) {
  constexpr Ticks year = 365 * 24 * 3600 * ticks_per_second;
  constexpr float frequency = 7.25F;
  const NoisePoint first = noise_at(ticks_per_second / 3, frequency);
  const NoisePoint later = noise_at(year + ticks_per_second / 3, frequency);
  EXPECT_EQ(later.fraction, first.fraction);
  EXPECT_EQ(later.lattice - first.lattice, std::int64_t{365} * 24 * 900 * 29);
}

TEST(Noise, RunsEvenlyThroughNegativeTimes) {
  for (const double seconds : {-3.7, -1.0, -0.25, 0.0, 0.25, 1.0, 3.7}) {
    const NoisePoint point = noise_at(to_ticks(seconds), 2.5F);
    EXPECT_NEAR(static_cast<double>(point.lattice) + static_cast<double>(point.fraction), seconds * 2.5, 1e-6);
    EXPECT_GE(point.fraction, 0.0F);
    EXPECT_LE(point.fraction, 1.0F);
  }
}

TEST(Noise, StandsStillAtNoFrequency) {
  EXPECT_EQ(noise_at(5 * ticks_per_second, 0.0F).lattice, 0);
  EXPECT_EQ(noise_at(5 * ticks_per_second, 0.0F).fraction, 0.0F);
}

TEST(Noise, HasAtMostHalfALatticePointATick) {
  const NoisePoint point = noise_at(Ticks{3}, 1e30F);
  EXPECT_NEAR(static_cast<double>(point.lattice) + static_cast<double>(point.fraction), 1.5, 1e-6);
}

TEST(Noise, DiffersBetweenSeedsBonesAndAxes) {
  const Noise noise{.point = {5, 0.3F}};
  Noise other_seed = noise;
  other_seed.seed = 18;
  Noise other_packet = noise;
  other_packet.packet = 3;
  EXPECT_GT(glm::length(turn_at(noise, 0) - turn_at(other_seed, 0)), 1e-3);
  EXPECT_GT(glm::length(turn_at(noise, 0) - turn_at(other_packet, 0)), 1e-3);
  EXPECT_GT(glm::length(turn_at(noise, 0) - turn_at(noise, 1)), 1e-3);
  EXPECT_GT(std::abs(turn_at(noise, 0).x - turn_at(noise, 0).y), 1e-3);
}

TEST(Noise, OfOneBoneOrAxisSaysLittleOfAnother) {
  constexpr int keys = 2000, values_of_a_key = packet_bones * 3;
  constexpr double most_correlation = 0.1, four_deviations = 4.0 / 44.7;  // of a chance correlation over so many keys
  std::vector<std::array<double, values_of_a_key>> values(keys);
  for (int key = 0; key < keys; ++key) {
    for (int i = 0; i < values_of_a_key; ++i) {
      values[static_cast<std::size_t>(key)].at(static_cast<std::size_t>(i)) =
          lattice_value({.point = {}, .seed = static_cast<std::uint64_t>(key)}, i % 3, 0, i / 3);
    }
  }
  double largest = 0.0;
  for (std::size_t a = 0; a < values_of_a_key; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      double sum = 0.0;
      for (const auto& of_a_key : values) sum += of_a_key.at(a) * of_a_key.at(b);
      largest = std::max(largest, std::abs(3.0 * sum / keys));
    }
  }
  EXPECT_LT(largest, most_correlation + four_deviations);
}

TEST(Noise, LeansToNoSide) {
  glm::dvec3 sum(0.0);
  for (std::int64_t point = 0; point < 2000; ++point) {
    for (int bone = 0; bone < packet_bones; ++bone) {
      sum += turn_at({.amplitudes = even_amplitudes(1.0F), .point = {point, 0.0F}}, bone);
    }
  }
  EXPECT_LT(glm::length(sum) / (2000.0 * packet_bones), 0.01);
}

TEST(Noise, KeepsTheBitsOfABoneWithoutAmplitude) {
  for (const Kernels& kernels : runnable_kernels()) {
    Noise noise{.point = {5, 0.3F}};
    for (int bone = 0; bone < packet_bones; bone += 2) noise.amplitudes.of[bone] = 0.0F;
    for (const Packet& from : {random_packet(1), identity_packet()}) {
      const Packet out = with_noise(kernels, from, noise);
      for (int bone = 0; bone < packet_bones; ++bone) {
        EXPECT_EQ(bone_bits(out, bone) == bone_bits(from, bone), bone % 2 == 0) << kernels.target << " " << bone;
      }
    }
  }
}

TEST(Noise, TurnsEveryBoneByTheSameAmplitudeWithoutWeightsAndNoneAboveTheBoneCount) {
  const Amplitudes whole = even_amplitudes(1.0F);
  const NoiseMoment moment = noise_moment(17, {5, 0.3F}, 0.2F);
  for (const Kernels& kernels : runnable_kernels()) {
    const Packet from = random_packet(3);
    Packet even{};
    Packet weighted{};
    const std::array characters = {
        ShakenBones{.from = from.data(), .out = even.data(), .moment = &moment, .bone_weights = nullptr},
        ShakenBones{.from = from.data(), .out = weighted.data(), .moment = &moment, .bone_weights = whole.of}};
    kernels.noise(
        {.characters = characters, .packet = 2, .bone_count = 2 * packet_bones + 5, .components = general_components});
    EXPECT_EQ(bits(even), bits(weighted)) << kernels.target;
    for (int bone = 0; bone < packet_bones; ++bone) {
      EXPECT_EQ(bone_bits(even, bone) == bone_bits(from, bone), bone >= 5) << kernels.target << " " << bone;
    }
  }
}

TEST(Noise, ShakesEachCharacterOfAStripAsItWouldAlone) {
  for (const Kernels& kernels : runnable_kernels()) {
    std::array<Packet, widest_strip> from;
    std::array<Packet, widest_strip> together{};
    std::array<NoiseMoment, widest_strip> moments;
    std::array<Amplitudes, widest_strip> shares;
    std::array<ShakenBones, widest_strip> characters;
    for (std::size_t i = 0; i < characters.size(); ++i) {
      const auto number = static_cast<float>(i);
      from[i] = random_packet(static_cast<unsigned>(i));
      moments[i] = noise_moment(i, {5, number / widest_strip}, number / 10.0F);
      shares[i] = even_amplitudes(number / widest_strip);
      characters[i] = {.from = from[i].data(),
                       .out = together[i].data(),
                       .moment = &moments[i],
                       .bone_weights = i % 2 == 0 ? nullptr : shares[i].of};
    }
    const NoiseJob strip{.characters = characters, .packet = 1, .bone_count = packet_bones + 9};
    kernels.noise(strip);
    for (std::size_t i = 0; i < characters.size(); ++i) {
      Packet alone{};
      characters[i].out = alone.data();
      NoiseJob job = strip;
      job.characters = {&characters[i], 1};
      kernels.noise(job);
      EXPECT_EQ(bits(alone), bits(together[i])) << kernels.target << " " << i;
    }
  }
}

TEST(Noise, MayWriteOverWhatItReadsAndDoesNotTouchWhatTheStateHasNot) {
  for (const Kernels& kernels : runnable_kernels()) {
    const Noise noise{.point = {5, 0.3F}};
    Packet over = random_packet(5);
    add_noise(kernels, over, noise, over);
    EXPECT_EQ(bits(over), bits(with_noise(kernels, random_packet(5), noise))) << kernels.target;
    Packet rigid{};
    add_noise(kernels, random_packet(5), noise, rigid, rigid_components);
    for (int bone = 0; bone < packet_bones; ++bone) EXPECT_EQ(scale_of(rigid, bone), glm::dvec3(0.0));
  }
}

TEST(Noise, IsTheSameToTheBitAmongTargetsThatFuse) {
  const Noise noise{.point = {123456789012, 0.3F}};
  const Packet best = with_noise(best_kernels(), random_packet(5), noise);
  for (const Kernels& kernels : runnable_kernels()) {
    if (kernels.fused_multiply_add != best_kernels().fused_multiply_add) continue;
    EXPECT_EQ(bits(with_noise(kernels, random_packet(5), noise)), bits(best)) << kernels.target;
  }
}

}  // namespace
}  // namespace throng::anim::noise_test
