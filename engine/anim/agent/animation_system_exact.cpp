// What level of detail is measured against: the poses of now, without a trace of having been looked at.

#include <algorithm>
#include <cassert>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/entity/foot_placement_entity.h"
#include "engine/anim/entity/inertialiser.h"

namespace throng::anim {
namespace {

// The offset was captured after that, or is about to be.
bool has_no_offset_of(const Inertialiser& offset, Ticks ahead) {
  return !has_left(offset) || offset.since_capture < ahead;
}

// Where feet were held and where they are let go to depends on frames in which nobody posed them.
bool holds_feet_of(const FootPlacementEntity& feet, Ticks ahead) {
  FadingWeight weight = feet.weight;
  advance_weight(weight, -static_cast<float>(to_seconds(ahead)));
  return value(weight) > 0.0F;
}

}  // namespace

bool AnimationSystem::can_pose_exactly(std::uint32_t agent) const {
  const Ticks ahead = posed_at_[agent] - clock_;
  return ahead <= 0 || std::ranges::none_of(graph(agent).entities, [&](Handle entity) {
           switch (pools(agent).state(entity).type) {
             case EntityType::inertialiser:
               return has_no_offset_of(pools(agent).as<Inertialiser>(entity), ahead);
             case EntityType::foot_placement:
               return holds_feet_of(pools(agent).as<FootPlacementEntity>(entity), ahead);
             default:
               return false;
           }
         });
}

bool AnimationSystem::can_wind_back(std::uint32_t agent) const {
  const Ticks ahead = posed_at_[agent] - clock_;
  return ahead <= 0 || std::ranges::none_of(graph(agent).entities, [&](Handle entity) {
           switch (pools(agent).state(entity).type) {
             case EntityType::foot_placement:
               return holds_feet_of(pools(agent).as<FootPlacementEntity>(entity), ahead);
             case EntityType::look_at:
             case EntityType::two_bone_ik:
             case EntityType::ragdoll:
             case EntityType::user:
               return true;
             default:
               return EntityPools::is_shared(entity);
           }
         });
}

void AnimationSystem::pose_exactly(std::span<const ExactPose> agents) {
  exact_work_.clear();
  for (const ExactPose& exact : agents) {
    const Member member = members_[exact.agent];
    const PoseGraph& graph = casts_[member.cast]->agents.graph(member.local);
    assert(!graph.empty() && "an agent must have been updated before");
    exact_work_.push_back({.program = graph.program,
                           .entities = graph.entities.data(),
                           .delta = clock_ - posed_at_[exact.agent],
                           .palette = exact.palette,
                           .agent = exact.agent,
                           .cost = predicted_cost(*graph.program, member.cast, 0),
                           .skeleton = static_cast<std::uint8_t>(member.cast),
                           .held = graph.program->needs.held});
  }
  exact_contexts_ = contexts_;
  for (UpdateContext& context : exact_contexts_) {
    context.palette_format = PaletteFormat::matrices;
    context.hashes = {};
  }
  if (exact_scheduler_ == nullptr || !exact_stores_hold()) make_exact_scheduler();
  find_runs(exact_work_, exact_runs_);
  exact_scheduler_->update(exact_contexts_, {}, {exact_work_, exact_runs_}, executor());
}

bool AnimationSystem::exact_stores_hold() const {
  const LocalStorePlan& plan = exact_scheduler_->options().plan;
  return std::ranges::all_of(exact_work_, [&](const AgentWork& work) {
    return plan_holds(plan, exact_contexts_[work.skeleton], Schedule::fused, work.program->needs);
  });
}

// Stores of its own, as large as need be, so that a look neither fails nor depends on how the crowd is scheduled.
void AnimationSystem::make_exact_scheduler() {
  LocalStoreDemand needs = local_store_demand(casts_, options_.stream);
  needs.schedule = Schedule::fused;
  needs.double_buffering = DoubleBuffering::off;
  const std::size_t bytes = automatic_local_store(exact_contexts_, needs);
  const Result<LocalStorePlan> plan = plan_local_store(exact_contexts_, needs, bytes, 0);
  assert(plan && "an automatic local store holds what it was made for");
  constexpr std::size_t no_unseen_palettes = 0;
  exact_scheduler_ = std::make_unique<Scheduler>(ScheduleOptions{.schedule = Schedule::fused,
                                                                 .double_buffering = DoubleBuffering::off,
                                                                 .plan = *plan,
                                                                 .local_store_bytes = bytes,
                                                                 .pus = options_.pus,
                                                                 .cost = options_.cost,
                                                                 .stores = StorePolicy::plain,
                                                                 .trace = Tracing::off,
                                                                 .block_changes = BlockChanges::dropped},
                                                 no_unseen_palettes);
  exact_scheduler_->reserve(agent_count());
}

}  // namespace throng::anim
