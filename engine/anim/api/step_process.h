#pragma once

#include <cstddef>
#include <memory>

#include "throng/processes.h"

#include "engine/anim/agent/one_entity_process.h"
#include "engine/anim/entity/animation_state.h"
#include "engine/anim/entity/entity_kind.h"

namespace throng::detail {

/// An entity that calls a step of the host's own (throng/processes.h) on the pose of its source.
///
///     [header 96 | step 32 | transforms if resident | StepKind::memory_bytes of the host's own]
struct alignas(64) StepEntity {
  anim::AnimationStateHeader state;  //   0
  anim::Handle source;               //  96
  std::uint32_t unused;              // 100
  Ticks elapsed;                     // 104  since the update before this one
  std::byte rest[16];                // 112
};
static_assert(sizeof(StepEntity) == anim::entity_header_bytes);
static_assert(offsetof(StepEntity, source) == 96 && offsetof(StepEntity, elapsed) == 104);

/// Returns why a crowd cannot take a step, in one sentence; null if it can.
const char* fault_of(const StepKind& step);
/// Returns the kind of entity that calls a step, which outlives it.
anim::EntityKind step_entity_kind(const StepKind& step);

class StepProcess final : public anim::OneEntityProcess<StepEntity> {
 public:
  explicit StepProcess(anim::EntityPools::Kind kind) : OneEntityProcess(kind) {}
  std::unique_ptr<PostProcess> clone() const override { return std::make_unique<StepProcess>(*this); }

 private:
  void begin(const anim::EntityBuilder&, anim::Handle) override {}  // its memory is zeroed
};

}  // namespace throng::detail
