#pragma once

#include "engine/anim/agent/one_entity_process.h"
#include "engine/anim/entity/noise_maker.h"

namespace throng::anim {

/// Adds animation noise, the paper's own example of a post process (2.1.2).
class NoiseProcess final : public OneEntityProcess<NoiseMaker> {
 public:
  struct Settings {
    float frequency = 0.5F;   ///< Hz
    float amplitude = 0.02F;  ///< radians
    std::uint32_t seed = 0;
    int mask = EaseBlender::no_mask;
  };
  explicit NoiseProcess(const Settings& settings) : OneEntityProcess(EntityPools::noise_makers), settings_(settings) {}

  const char* fault(const EntityBuilder& build) const override {
    if (!build.has_mask(settings_.mask)) return not_a_mask;
    constexpr float half_turn = 3.14159265F;
    const bool are_numbers = settings_.frequency >= 0.0F && settings_.amplitude >= 0.0F;
    const bool are_small = settings_.frequency <= 1e6F && settings_.amplitude <= half_turn;
    return are_numbers && are_small ? OneEntityProcess::fault(build)
                                    : "frequency is from 0 to 1 MHz, and amplitude to half a turn";
  }
  std::unique_ptr<PostProcess> clone() const override { return std::make_unique<NoiseProcess>(*this); }

 private:
  void begin(const EntityBuilder& build, Handle entity) override {
    auto& noise = build.as<NoiseMaker>(entity);
    noise.time = build.now() + build.lead();
    noise.frequency = settings_.frequency;
    noise.amplitude = settings_.amplitude;
    noise.seed = settings_.seed;
    noise.mask = static_cast<std::int16_t>(settings_.mask);
  }

  Settings settings_;
};

}  // namespace throng::anim
