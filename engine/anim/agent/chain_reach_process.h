#pragma once

#include <cstdint>

#include "engine/anim/agent/weighted_process.h"
#include "engine/anim/entity/chain_reach_entity.h"

namespace throng::anim {

/// Lets any chain of bones, such as a tail or a spine, reach for a place. Its weight is 0 until it is set.
class ChainReachProcess final : public TargetedProcess<ChainReachEntity> {
 public:
  struct Settings {
    std::uint32_t chain = 0;  ///< index into the chains of the kind
    int iterations = 16;      ///< see ChainReachJob
    float tolerance = 1e-3F;
  };
  /// `kind` is what Characters::add_entity_kind returned for chain_reach_kind(chains).
  explicit ChainReachProcess(EntityPools::Kind kind, const Settings& settings)
      : TargetedProcess(kind, {0.0F, 0.0F, 0.0F}), settings_(settings) {}

  /// Returns the metres from the end of the chain to the target at the last update.
  float missed_by(const EntityPools& pools) const {
    return entity().valid() ? pools.private_as<ChainReachMemory>(entity()).missed_by : 0.0F;
  }

  const char* fault(const EntityBuilder& build) const override {
    if (const char* const no_kind = TargetedProcess::fault(build); no_kind != nullptr) return no_kind;
    if (settings_.chain >= resource<std::vector<ReachChain>>(build).size())
      return "chain is not one of the kind's chains";
    const bool ends = settings_.iterations >= 1 && settings_.iterations <= most_reach_iterations;
    return ends && settings_.tolerance >= 0.0F ? nullptr : "iterations are from 1 to 64, and tolerance is not negative";
  }
  std::unique_ptr<PostProcess> clone() const override { return std::make_unique<ChainReachProcess>(*this); }

 private:
  void begin_private(const EntityBuilder& build, Handle reach) const override {
    build.private_as<ChainReachMemory>(reach) = {.chain = settings_.chain,
                                                 .iterations = settings_.iterations,
                                                 .tolerance = settings_.tolerance,
                                                 .missed_by = 0.0F};
  }

  Settings settings_;
};

}  // namespace throng::anim
