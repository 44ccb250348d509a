#include "engine/anim/agent/pose_weights.h"

#include <algorithm>

#include "engine/anim/entity/additive_layer.h"
#include "engine/anim/entity/ease_blender.h"
#include "engine/anim/entity/mixer.h"

namespace throng::anim {
namespace {

float fraction_at(const EaseBlender& blender, Ticks since_posed) {
  EaseBlender moved = blender;
  moved.state.delta_time += since_posed;
  advance_blender(moved);
  return moved.fraction;
}

}  // namespace

// Returns the weight of a mask at a bone, or all that it has, as a range.
MaskRange PoseSharing::mask_at(const Asked& asked, std::int16_t mask) const {
  if (mask == EaseBlender::no_mask) return {.least = 1.0F, .most = 1.0F};
  const auto index = static_cast<std::size_t>(mask);
  if (asked.part == Part::anywhere) return index < masks_->ranges.size() ? masks_->ranges[index] : MaskRange{};
  const float weight = masks_->masks[index][asked.bone];
  return {.least = weight, .most = weight};
}

// A blend under a mask moves some bones and not the agent.
void PoseSharing::share_blended(const Asked& asked, std::size_t step, PoseWeights& weights) const {
  const auto& blender = pools_->as<EaseBlender>(graph_->entities[step]);
  const PoseStep& own = graph_->program->steps[step];
  MaskRange to{.least = 0.0F, .most = 0.0F};
  if (asked.part != Part::motion || blender.mask == EaseBlender::no_mask) {
    const float fraction = fraction_at(blender, since_posed_);
    const MaskRange mask = mask_at(asked, blender.mask);
    to = {.least = fraction * mask.least, .most = fraction * mask.most};
  }
  weights[own.sources[0]] += weights[step] * (1.0F - to.least);
  weights[own.sources[1]] += weights[step] * to.most;
}

void PoseSharing::share_mixed(const Asked& asked, std::size_t step, PoseWeights& weights) const {
  const auto& mixer = pools_->as<Mixer>(graph_->entities[step]);
  const MixerSources& mixed = pools_->private_as<MixerSources>(graph_->entities[step]);
  const PoseStep& own = graph_->program->steps[step];
  const auto range = [&](std::size_t i) {
    const MaskRange mask = asked.part == Part::motion ? MaskRange{.least = 1.0F} : mask_at(asked, mixer.masks[i]);
    return MaskRange{.least = mixed.weights[i] * mask.least, .most = mixed.weights[i] * mask.most};
  };
  for (std::size_t i = 0; i < own.source_count; ++i) {
    const float most = range(i).most;
    float sum = 0.0F;
    for (std::size_t k = 0; k < own.source_count; ++k) sum += k == i ? most : range(k).least;
    if (sum > 0.0F) weights[own.sources[i]] += weights[step] * most / sum;
  }
}

void PoseSharing::share_layered(const Asked& asked, std::size_t step, PoseWeights& weights) const {
  const auto& layer = pools_->as<AdditiveLayer>(graph_->entities[step]);
  const PoseStep& own = graph_->program->steps[step];
  weights[own.sources[0]] += weights[step];
  if (asked.part == Part::motion) return;
  const float added = weights[step] * layer.weight * mask_at(asked, layer.mask).most;
  weights[own.sources[1]] += added;
  if (asked.part == Part::bone) weights[own.sources[2]] -= added;  // what is only subtracted is not felt
}

void PoseSharing::share(const Asked& asked, std::size_t step, PoseWeights& weights) const {
  const PoseStep& own = graph_->program->steps[step];
  if (own.source_count == 0) return;
  switch (graph_->entities[step].pool()) {
    case EntityPools::ease_blenders:
      return share_blended(asked, step, weights);
    case EntityPools::mixers:
      return share_mixed(asked, step, weights);
    case EntityPools::additive_layers:
      return share_layered(asked, step, weights);
    default:
      weights[own.sources[0]] += weights[step];
  }
}

PoseWeights PoseSharing::weights(Part part, int bone) const {
  PoseWeights weights{};
  if (graph_->empty()) return weights;
  const std::size_t count = graph_->program->steps.size();
  weights[count - 1] = 1.0F;
  for (std::size_t step = count; step-- > 0;) share({.part = part, .bone = bone}, step, weights);
  return weights;
}

}  // namespace throng::anim
