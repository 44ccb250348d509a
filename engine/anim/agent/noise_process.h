#pragma once

#include <utility>

#include "engine/anim/agent/post_process.h"
#include "engine/anim/entity/noise_maker.h"

namespace throng::anim {

/// Animation noise, the paper's own example of a post process (2.1.2).
class NoiseProcess final : public PostProcess {
 public:
  struct Settings {
    float frequency = 0.5F;   ///< Hz
    float amplitude = 0.02F;  ///< radians
    std::uint32_t seed = 0;
    int mask = EaseBlender::no_mask;
  };
  explicit NoiseProcess(const Settings& settings) : settings_(settings) {}

  Handle attach(const EntityBuilder& build, Handle source) override {
    if (!entity_.valid()) {
      entity_ = build.create(EntityPools::noise_makers);
      auto& noise = build.as<NoiseMaker>(entity_);
      noise.time = build.now() + build.lead();
      noise.frequency = settings_.frequency;
      noise.amplitude = settings_.amplitude;
      noise.seed = settings_.seed;
      noise.mask = static_cast<std::int16_t>(settings_.mask);
    }
    build.as<NoiseMaker>(entity_).source = source;
    return entity_;
  }
  void visit_handles(const std::function<void(Handle&)>& visit) override {
    if (entity_.valid()) visit(entity_);
  }
  void destroy_entities(const EntityBuilder& build) override {
    if (entity_.valid()) build.destroy(std::exchange(entity_, {}));
  }
  std::unique_ptr<PostProcess> clone() const override { return std::make_unique<NoiseProcess>(*this); }

 private:
  Settings settings_;
  Handle entity_;
};

}  // namespace throng::anim
