#include "engine/anim/agent/exact_poser.h"

#include <algorithm>
#include <cassert>

#include "engine/anim/base/misuse.h"
#include "engine/anim/base/room.h"

namespace throng::anim {
namespace {

const char* fault_of(const Population& population, const ExactPose& exact) {
  if (!population.numbers().has(exact.agent)) return no_agent;
  if (population.graph(exact.agent.number).empty()) return "an agent plays something before it is posed";
  const std::size_t bones = population.character_of(exact.agent.number).skeleton().bones.size();
  if (!exact.locals.empty() && exact.locals.size() < bones) return "local transforms have room for every bone";
  const PaletteDestination palette = exact.palette;
  if (palette == nullptr && exact.locals.empty()) return "neither a palette nor local transforms are asked for";
  return palette.is_misaligned() ? "a palette lies at a multiple of 16 bytes" : nullptr;
}

}  // namespace

void ExactPoser::pose(const Population& population, const FittedScheduler& crowd, std::span<const ExactPose> agents) {
  for (const ExactPose& exact : agents) {
    const char* const fault = fault_of(population, exact);
    if (fault != nullptr) report_misuse({"Crowd::pose_exactly", fault});
  }
  for (const Written written : {Written::palettes, Written::locals}) pose_as(written, population, crowd, agents);
}

void ExactPoser::pose_as(Written written, const Population& population, const FittedScheduler& crowd,
                         std::span<const ExactPose> agents) {
  // A frame that poses more agents than the ones before must not allocate.
  make_room(work_, population.numbers().count());
  make_room(runs_, population.numbers().count());
  work_.clear();
  for (const ExactPose& exact : agents) {
    PaletteDestination to = exact.palette;
    if (written == Written::locals) to = PaletteDestination(reinterpret_cast<std::byte*>(exact.locals.data()));
    if (to == nullptr || fault_of(population, exact) != nullptr) continue;
    add_work(population, crowd, exact.agent.number, to);
  }
  if (!work_.empty()) run(written, population, crowd);
}

void ExactPoser::run(Written written, const Population& population, const FittedScheduler& crowd) {
  contexts_.assign(crowd.contexts().begin(), crowd.contexts().end());
  for (std::size_t character = 0; character < contexts_.size(); ++character) {
    UpdateContext& context = contexts_[character];
    context.palette_format = PaletteFormat::matrices;
    context.hashes = {};
    context.joint_programs = {};
    if (written == Written::locals) context.locals_of = &population.characters()[character]->skeleton();
  }
  if (scheduler_ == nullptr || made_for_ != crowd.version() || !stores_hold()) make_scheduler(population, crowd);
  find_runs(work_, runs_);
  scheduler_->update(contexts_, {}, {work_, runs_}, crowd.executor());
}

void ExactPoser::add_work(const Population& population, const FittedScheduler& crowd, std::uint32_t agent,
                          PaletteDestination destination) {
  const PoseGraph& graph = population.graph(agent);
  const std::uint32_t character = population.numbers().member(agent).character;
  work_.push_back({.program = graph.program,
                   .entities = graph.entities.data(),
                   .delta = population.clock() - population.posed_at(agent),
                   .palette = destination,
                   .agent = agent,
                   .cost = crowd.predicted_cost(*graph.program, character, 0),
                   .skeleton = static_cast<std::uint8_t>(character),
                   .held = graph.program->needs.held});
}

bool ExactPoser::stores_hold() const {
  const LocalStorePlan& plan = scheduler_->options().plan;
  return std::ranges::all_of(work_, [&](const AgentWork& work) {
    return plan_holds(plan, contexts_[work.skeleton], Schedule::fused, work.program->needs);
  });
}

// Stores of its own, as large as need be.
void ExactPoser::make_scheduler(const Population& population, const FittedScheduler& crowd) {
  LocalStoreDemand needs = local_store_demand(population.characters(), crowd.options().stream);
  needs.schedule = Schedule::fused;
  needs.double_buffering = DoubleBuffering::off;
  const std::size_t bytes = automatic_local_store(contexts_, needs);
  const Result<LocalStorePlan> plan = plan_local_store(contexts_, needs, bytes, 0);
  assert(plan && "an automatic local store holds what it was made for");
  constexpr std::size_t no_unseen_palettes = 0;
  scheduler_ = std::make_unique<Scheduler>(ScheduleOptions{.schedule = Schedule::fused,
                                                           .double_buffering = DoubleBuffering::off,
                                                           .plan = *plan,
                                                           .local_store_bytes = bytes,
                                                           .pus = crowd.options().pus,
                                                           .cost = crowd.options().cost,
                                                           .stores = StorePolicy::plain,
                                                           .trace = Tracing::off,
                                                           .block_changes = BlockChanges::dropped},
                                           no_unseen_palettes);
  scheduler_->reserve(population.numbers().number_limit());
  made_for_ = crowd.version();
}

}  // namespace throng::anim
