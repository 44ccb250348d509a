#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/kernel/kernels.h"
#include "tests/anim/kernel/pose/random_packet.h"
#include "tests/anim/kernel/validity.h"

namespace throng::anim::mix_test {
namespace {

struct alignas(64) BoneWeights {
  float of[packet_bones];
};

/// Sources with their weights; an empty `bone_weights` is none at all, a null in it is none for that source.
struct Mixture {
  std::vector<Packet> sources;
  std::vector<float> weights;
  std::vector<const BoneWeights*> bone_weights;

  double weight(std::size_t source, int bone) const {
    const bool masked = !bone_weights.empty() && bone_weights[source] != nullptr;
    return static_cast<double>(weights[source]) * (masked ? static_cast<double>(bone_weights[source]->of[bone]) : 1.0);
  }
};

Mixture random_mixture(std::size_t count, unsigned seed) {
  Mixture mixture;
  float total = 0.0F;
  for (std::size_t source = 0; source < count; ++source) {
    mixture.sources.push_back(random_packet(seed * 100U + static_cast<unsigned>(source)));
    mixture.weights.push_back(static_cast<float>((seed * 7U + source * 13U) % 17U + 1U));
    total += mixture.weights.back();
  }
  for (float& weight : mixture.weights) weight /= total;
  return mixture;
}

BoneWeights random_bone_weights(unsigned seed) {
  BoneWeights weights{};
  for (int bone = 0; bone < packet_bones; ++bone) {
    weights.of[bone] = static_cast<float>((seed * 5U + static_cast<unsigned>(bone) * 11U) % 16U) / 15.0F;
  }
  return weights;
}

void mix_into(const Kernels& kernels, const Mixture& mixture, Packet& out, int components = general_components) {
  std::vector<const float*> sources;
  for (const Packet& source : mixture.sources) sources.push_back(source.data());
  std::vector<const float*> bone_weights;
  for (const BoneWeights* weights : mixture.bone_weights) {
    bone_weights.push_back(weights != nullptr ? weights->of : nullptr);
  }
  kernels.mix({.sources = sources.data(),
               .weights = mixture.weights.data(),
               .bone_weights = bone_weights.empty() ? nullptr : bone_weights.data(),
               .count = static_cast<int>(sources.size()),
               .components = components,
               .out = out.data()});
}

Packet mix(const Kernels& kernels, const Mixture& mixture) {
  Packet out{};
  mix_into(kernels, mixture, out);
  return out;
}

void expect_reference(const Kernels& kernels, const Mixture& mixture) {
  const Packet out = mix(kernels, mixture);
  for (int bone = 0; bone < packet_bones; ++bone) {
    glm::dquat rotation(0.0, 0.0, 0.0, 0.0);
    glm::dvec3 position(0.0);
    glm::dvec3 scale(0.0);
    double total = 0.0;
    for (std::size_t source = 0; source < mixture.sources.size(); ++source) {
      const double weight = mixture.weight(source, bone);
      const glm::dquat q = rotation_of(mixture.sources[source], bone);
      rotation = rotation + q * (glm::dot(rotation, q) < 0.0 ? -weight : weight);
      position += position_of(mixture.sources[source], bone) * weight;
      scale += scale_of(mixture.sources[source], bone) * weight;
      total += weight;
    }
    ASSERT_GT(total, 0.0) << "the test's own mixture";
    EXPECT_LT(glm::length(rotation_of(out, bone) - glm::normalize(rotation)), 3e-6) << kernels.target << " " << bone;
    EXPECT_LT(glm::length(position_of(out, bone) - position / total), 1e-6) << kernels.target << " " << bone;
    EXPECT_LT(glm::length(scale_of(out, bone) - scale / total), 1e-6) << kernels.target << " " << bone;
  }
}

/// Everything that the rows of the validity table point a job at.
struct Mixed {
  alignas(64) static constexpr float too_heavy[packet_bones] = {1.1F};
  static constexpr const float* masks_too_heavy[] = {nullptr, too_heavy};
  static constexpr float halves[] = {0.5F, 0.5F}, zeros[] = {0.0F, 0.0F}, more_than_one[] = {0.5F, 0.6F};
  static constexpr float negative[] = {1.5F, -0.5F}, none[] = {NAN, 1.0F};
  static inline const Packet packet = random_packet(1);
  static inline const float* const sources[] = {packet.data(), packet.data()};
  static inline const float* const one_missing[] = {packet.data(), nullptr};
  static inline const float* const off_the_alignment[] = {packet.data(), packet.data() + 4};
};

TEST(MixJob, IsValidAsItsCommentsSay) {
  Packet out{};
  const MixJob job{.sources = Mixed::sources,
                   .weights = Mixed::halves,
                   .count = 2,
                   .components = general_components,
                   .out = out.data()};
  expect_validity<MixJob>(
      job, {{false, "no sources", [](MixJob& job) { job.sources = nullptr; }},
            {false, "a source missing", [](MixJob& job) { job.sources = Mixed::one_missing; }},
            {false, "a source off the alignment", [](MixJob& job) { job.sources = Mixed::off_the_alignment; }},
            {false, "no weights", [](MixJob& job) { job.weights = nullptr; }},
            {true, "no weight above 0", [](MixJob& job) { job.weights = Mixed::zeros; }},
            {false, "weights of more than 1", [](MixJob& job) { job.weights = Mixed::more_than_one; }},
            {false, "a negative weight", [](MixJob& job) { job.weights = Mixed::negative; }},
            {false, "a weight that is not a number", [](MixJob& job) { job.weights = Mixed::none; }},
            {false, "a bone weight above 1", [](MixJob& job) { job.bone_weights = Mixed::masks_too_heavy; }},
            {false, "nothing to mix", [](MixJob& job) { job.count = 0; }},
            {false, "too many sources", [](MixJob& job) { job.count = most_mixed_sources + 1; }},
            {false, "no out", [](MixJob& job) { job.out = nullptr; }},
            {false, "out off the alignment", [](MixJob& job) { job.out += 4; }},
            {true, "rigid", [](MixJob& job) { job.components = rigid_components; }},
            {false, "eight components", [](MixJob& job) { job.components = 8; }}});
}

TEST(Mix, AgreesWithDoublePrecisionForEveryNumberOfSources) {
  for (const Kernels& kernels : runnable_kernels()) {
    for (std::size_t count = 1; count <= most_mixed_sources; ++count) {
      for (unsigned seed = 0; seed < 20; ++seed) expect_reference(kernels, random_mixture(count, seed));
    }
  }
}

TEST(Mix, SharesOutTheBoneWeightsAnewForEveryBone) {
  for (const Kernels& kernels : runnable_kernels()) {
    for (unsigned seed = 0; seed < 20; ++seed) {
      Mixture mixture = random_mixture(4, seed);
      const BoneWeights first = random_bone_weights(seed);
      const BoneWeights third = random_bone_weights(seed + 3);
      mixture.bone_weights = {&first, nullptr, &third, nullptr};
      expect_reference(kernels, mixture);
    }
  }
}

TEST(Mix, OfTwoIsTheirBlend) {
  for (const Kernels& kernels : runnable_kernels()) {
    Mixture mixture = random_mixture(2, 3);
    mixture.weights = {0.7F, 0.3F};
    Packet blended{};
    kernels.blend({.from = mixture.sources[0].data(),
                   .to = mixture.sources[1].data(),
                   .fraction = 0.3F,
                   .components = general_components,
                   .out = blended.data()});
    const Packet mixed = mix(kernels, mixture);
    for (int component = 0; component < general_components; ++component) {
      for (int bone = 0; bone < packet_bones; ++bone) {
        EXPECT_NEAR(mixed.lanes[component][bone], blended.lanes[component][bone], 1e-6F) << kernels.target;
      }
    }
  }
}

TEST(Mix, CopiesTheBitsOfASourceThatWeighsAll) {
  for (const Kernels& kernels : runnable_kernels()) {
    for (std::size_t sole = 0; sole < 3; ++sole) {
      Mixture mixture = random_mixture(3, 9);
      mixture.sources[sole] = identity_packet();  // has a -0 where others would have rounded it away
      mixture.weights.assign(3, 0.0F);
      mixture.weights[sole] = 1.0F;
      EXPECT_EQ(bits(mix(kernels, mixture)), bits(mixture.sources[sole])) << kernels.target << " " << sole;
    }
  }
}

TEST(Mix, IsNotTouchedByASourceThatWeighsNothing) {
  for (const Kernels& kernels : runnable_kernels()) {
    const Mixture without = random_mixture(3, 4);
    for (std::size_t at = 0; at <= 3; ++at) {
      Mixture with = without;
      with.sources.insert(with.sources.begin() + static_cast<std::ptrdiff_t>(at), random_packet(77));
      with.weights.insert(with.weights.begin() + static_cast<std::ptrdiff_t>(at), 0.0F);
      EXPECT_EQ(bits(mix(kernels, with)), bits(mix(kernels, without))) << kernels.target << " " << at;
    }
  }
}

TEST(Mix, CopiesABoneThatOneSourceAloneWeighsAndTakesTheFirstWhereNoneDoes) {
  BoneWeights even{};
  BoneWeights upper{};
  for (int bone = 0; bone < packet_bones; ++bone) {
    even.of[bone] = bone % 2 == 0 ? 0.3F : 0.0F;
    upper.of[bone] = bone >= 8 ? 0.7F : 0.0F;
  }
  for (const Kernels& kernels : runnable_kernels()) {
    Mixture mixture = random_mixture(2, 6);
    mixture.bone_weights = {&upper, &even};
    const Packet out = mix(kernels, mixture);
    for (int bone = 0; bone < packet_bones; ++bone) {
      const bool both = bone >= 8 && bone % 2 == 0;
      if (both) continue;
      const std::size_t expected = bone < 8 && bone % 2 == 0 ? 1 : 0;
      EXPECT_EQ(bone_bits(out, bone), bone_bits(mixture.sources[expected], bone)) << kernels.target << " " << bone;
    }
  }
}

TEST(Mix, KeepsTheFirstSourcesSignAndTurnsTheOthersToIt) {
  for (const Kernels& kernels : runnable_kernels()) {
    Mixture mixture = random_mixture(3, 8);
    mixture.weights = {0.2F, 0.6F, 0.2F};  // the one that is turned would win
    mixture.sources[1] = mixture.sources[0];
    for (int component = 0; component < 4; ++component) {
      for (float& value : mixture.sources[1].lanes[component]) value = -value;
    }
    mixture.sources[2] = mixture.sources[0];
    const Packet out = mix(kernels, mixture);
    for (int bone = 0; bone < packet_bones; ++bone) {
      EXPECT_LT(glm::length(rotation_of(out, bone) - rotation_of(mixture.sources[0], bone)), 1e-6) << kernels.target;
    }
  }
}

TEST(Mix, MayWriteOverAnySource) {
  for (const Kernels& kernels : runnable_kernels()) {
    const Mixture mixture = random_mixture(4, 5);
    const Packet expected = mix(kernels, mixture);
    for (std::size_t over = 0; over < mixture.sources.size(); ++over) {
      Mixture written = mixture;
      mix_into(kernels, written, written.sources[over]);
      EXPECT_EQ(bits(written.sources[over]), bits(expected)) << kernels.target << " " << over;
    }
  }
}

TEST(Mix, DoesNotTouchWhatTheStateHasNot) {
  for (const Kernels& kernels : runnable_kernels()) {
    Packet out{};
    mix_into(kernels, random_mixture(3, 2), out, rigid_components);
    for (int component = rigid_components; component < general_components; ++component) {
      for (const float value : out.lanes[component]) EXPECT_EQ(value, 0.0F) << kernels.target;
    }
  }
}

TEST(Mix, IsTheSameToTheBitAmongTargetsThatFuse) {
  Mixture mixture = random_mixture(6, 11);
  const BoneWeights masks[] = {random_bone_weights(1), random_bone_weights(2)};
  mixture.bone_weights = {&masks[0], nullptr, &masks[1], nullptr, nullptr, &masks[0]};
  const Packet best = mix(best_kernels(), mixture);
  for (const Kernels& kernels : runnable_kernels()) {
    if (kernels.fused_multiply_add != best_kernels().fused_multiply_add) continue;
    EXPECT_EQ(bits(mix(kernels, mixture)), bits(best)) << kernels.target;
  }
}

}  // namespace
}  // namespace throng::anim::mix_test
