#include "engine/anim/agent/animation_system.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <utility>

#include "engine/anim/base/hash.h"

namespace throng::anim {
namespace {

ClipStreams streams_of(const BakedClip& clip) {
  return {.keyframe = &clip.keyframe(),
          .sampled = clip.sampled(),
          .duration = clip.duration,
          .root_motion = &clip.root_motion,
          .data_keys = clip.data_keys};
}

void reserve_fades(EntityPools& pools, StreamKind stream, std::size_t agents) {
  constexpr std::size_t players_of_a_fade = 2;
  const bool sampled = stream == StreamKind::sampled;
  pools.pool(sampled ? EntityPools::sampled_players : EntityPools::keyframe_players)
      .reserve(players_of_a_fade * agents);
  pools.pool(EntityPools::ease_blenders).reserve(agents);
}

Residency residency_for(Schedule schedule) {
  return schedule == Schedule::fused ? Residency::transient : Residency::resident;
}

}  // namespace

AnimationSystem::AnimationSystem(std::shared_ptr<const Character> character)
    : character_(std::move(character)),
      pools_(character_->skeleton.bone_count(), character_->skeleton.components(), Residency::transient),
      agents_(pools_) {
  for (const BakedClip& clip : character_->clips) clips_.push_back(streams_of(clip));
  context_ = {.hierarchy = &character_->hierarchy,
              .assets = {.clips = clips_,
                         .masks = {},
                         .selections = {},
                         .kernels = &best_kernels(),
                         .bone_count = character_->skeleton.bone_count(),
                         .components = character_->skeleton.components()},
              .level_bone_counts = character_->skeleton.level_bone_counts,
              .pools = &pools_};
}

AnimationSystem::~AnimationSystem() = default;

Result<std::unique_ptr<AnimationSystem>> AnimationSystem::create(std::shared_ptr<const Character> character,
                                                                 const SystemOptions& options) {
  std::unique_ptr<AnimationSystem> system(new AnimationSystem(std::move(character)));
  const Status configured = system->configure(options);
  if (!configured) return configured.error();
  return system;
}

LocalStoreDemand AnimationSystem::demand(const SystemOptions& options) const {
  const bool sampled = options.stream == StreamKind::sampled;
  const auto has_sampled = [](const ClipStreams& clip) { return clip.sampled != nullptr; };
  return {.skeleton = character_->skeleton.name,
          .schedule = options.schedule,
          .double_buffering = options.double_buffering,
          .any_sampled = sampled && std::ranges::any_of(clips_, has_sampled),
          .any_keyframe = !sampled || !std::ranges::all_of(clips_, has_sampled),
          .largest = agents_.largest_needs()};
}

Status AnimationSystem::configure(const SystemOptions& options) {
  const Residency before = pools_.residency();
  set_residency(residency_for(options.schedule));
  set_stream(options.stream);
  const LocalStoreDemand needs = demand(options);
  const std::size_t store_bytes =
      options.local_store_bytes == 0 ? automatic_local_store({&context_, 1}, needs) : options.local_store_bytes;
  const Result<LocalStorePlan> plan = plan_local_store({&context_, 1}, needs, store_bytes, options.tile);
  if (!plan) {
    set_stream(options_.stream);
    set_residency(before);
    return plan.error();
  }
  reserve_fades(pools_, options.stream, agent_count());
  context_.assets.kernels = options.kernels == nullptr ? &best_kernels() : options.kernels;
  scheduler_ = std::make_unique<Scheduler>(ScheduleOptions{.schedule = options.schedule,
                                                           .double_buffering = options.double_buffering,
                                                           .plan = *plan,
                                                           .local_store_bytes = store_bytes,
                                                           .pus = options.pus},
                                           static_cast<std::size_t>(character_->skeleton.palette_count()));
  scheduler_->reserve(agent_count());
  if (options.executor != nullptr) {
    threads_.reset();
  } else if (threads_ == nullptr || options.pus != options_.pus) {
    threads_ = std::make_unique<PuThreads>(options.pus);
  }
  options_ = options;
  return Done{};
}

void AnimationSystem::set_residency(Residency residency) {
  if (residency == pools_.residency()) return;
  pools_.set_residency(residency);
  agents_.recompile();
}

void AnimationSystem::set_stream(StreamKind stream) {
  for (std::uint32_t agent = 0; agent < agent_count(); ++agent) {
    agents_.restream(EntityBuilder(pools_, clips_, {.owner = agent, .stream = stream}), agent);
  }
  agents_.recompile();
}

void AnimationSystem::set_agent_count(std::uint32_t agents) {
  reserve_fades(pools_, options_.stream, agents);
  agents_.resize(agents);
  posed_at_.resize(agents, clock_);
  agent_hashes_.resize(agents, 0);
  work_.reserve(agents);
  scheduler_->reserve(agents);
}

EntityBuilder AnimationSystem::builder(std::uint32_t agent) {
  return {pools_, clips_, {.owner = agent, .now = clock_, .posed_at = posed_at_[agent], .stream = options_.stream}};
}

int AnimationSystem::add_mask(BoneMask mask) {
  assert(mask.packets() == packets_for(character_->skeleton.bone_count()) && "a mask of another skeleton");
  assert(masks_.size() < std::numeric_limits<std::int16_t>::max());
  mask_weights_.push_back(mask.packet(0));
  masks_.push_back(std::move(mask));
  context_.assets.masks = mask_weights_;
  return static_cast<int>(masks_.size()) - 1;
}

std::uint32_t AnimationSystem::add_bone_selection(BoneSelection selection) {
  assert(selection.packets() == packets_for(character_->skeleton.bone_count()) && "a selection of another skeleton");
  selections_.push_back(std::move(selection));
  context_.assets.selections = selections_;
  return static_cast<std::uint32_t>(selections_.size());
}

bool AnimationSystem::play(std::uint32_t agent, const PlayRequest& request) {
  assert(request.mask >= PlayRequest::no_mask && request.mask < static_cast<int>(masks_.size()) &&
         "PlayRequest::mask is not one that add_mask returned");
  const EntityBuilder build = builder(agent);
  if (agents_.channel_count(agent) == 0) {
    [[maybe_unused]] const Status added = agents_.add_channel(build, agent, std::make_unique<CrossFadeChannel>(), {});
    assert(added && "a channel that plays nothing yet");
  }
  assert(dynamic_cast<CrossFadeChannel*>(&agents_.channel(agent, 0)) != nullptr && "another kind of channel was added");
  const bool taken = static_cast<CrossFadeChannel&>(agents_.channel(agent, 0)).play(build, request);
  [[maybe_unused]] const Status changed = settled(agent, agents_.rebuild(build, agent));
  assert(changed && "room for an interrupted fade of every agent is set aside");
  return taken;
}

void AnimationSystem::set_speed(std::uint32_t agent, double speed) {
  static_cast<CrossFadeChannel&>(agents_.channel(agent, 0)).set_speed(builder(agent), speed);
}

Status AnimationSystem::add_channel(std::uint32_t agent, std::unique_ptr<Channel> channel,
                                    const LayerSettings& settings) {
  return settled(agent, agents_.add_channel(builder(agent), agent, std::move(channel), settings));
}

Status AnimationSystem::add_post_process(std::uint32_t agent, std::unique_ptr<PostProcess> process) {
  const Status added = settled(agent, agents_.add_post_process(builder(agent), agent, std::move(process)));
  if (!added) agents_.remove_last_post_process(builder(agent), agent);
  return added;
}

Status AnimationSystem::process_changed(std::uint32_t agent, std::size_t index) {
  const Status changed = settled(agent, agents_.update_post_process(builder(agent), agent, index));
  if (changed) return changed;
  agents_.post_process(agent, index).destroy_entities(builder(agent));
  [[maybe_unused]] const Status rebuilt = agents_.rebuild(builder(agent), agent);
  assert(rebuilt && "it did before");
  return changed;
}

void AnimationSystem::remove_post_processes(std::uint32_t agent) {
  agents_.remove_post_processes(builder(agent), agent);
}

void AnimationSystem::set_channel_weight(std::uint32_t agent, std::size_t channel, float weight) {
  agents_.set_weight(agent, channel, weight);
}

// What an agent asks of the local store after a change may be more than any did before.
Status AnimationSystem::settled(std::uint32_t agent, Status changed) {
  if (!changed) return changed;
  const StoreNeeds& needs = agents_.program(agent).needs;
  if (plan_holds(schedule().plan, context_, options_.schedule, needs)) return changed;
  LocalStoreDemand larger = demand(options_);
  larger.largest.widen(needs);
  const Result<LocalStorePlan> plan =
      plan_local_store({&context_, 1}, larger, schedule().local_store_bytes, options_.tile);
  if (!plan) return plan.error();
  scheduler_->set_plan(*plan);
  return changed;
}

void AnimationSystem::update(std::span<const AgentUpdate> agents) {
  ++frame_;
  report_ = {};
  begin_work(agents);
  scheduler_->update({&context_, 1}, {}, work_, executor());
  end_work();
}

void AnimationSystem::update_channels(std::uint32_t agent) {
  [[maybe_unused]] const Status updated = settled(agent, agents_.update(builder(agent), agent));
  assert(updated && "a channel changed by itself to a graph that cannot be run");
}

void AnimationSystem::begin_work(std::span<const AgentUpdate> agents) {
  work_.clear();
  std::array<std::uint64_t, max_bone_levels> agents_by_level{};
  for (const AgentUpdate& update : agents) {
    const Ticks time = std::max(clock_ + update.look_ahead, posed_at_[update.agent]);
    if (agents_.next_update(update.agent) <= clock_) update_channels(update.agent);
    const PoseProgram& program = agents_.program(update.agent);
    assert(!program.steps.empty() && "an agent must play something before it is updated");
    work_.push_back({.program = &program,
                     .delta = time - posed_at_[update.agent],
                     .palette = update.palette,
                     .hash = options_.hash ? &agent_hashes_[update.agent] : nullptr,
                     .agent = update.agent,
                     .level = update.level,
                     .entity_count = program.own_count,
                     .held = program.needs.held});
    posed_at_[update.agent] = time;
    ++agents_by_level[update.level];
  }
  report_.agents_updated = static_cast<std::uint32_t>(agents.size());
  for (std::size_t level = 0; level < context_.level_bone_counts.size(); ++level) {
    const int bones = context_.level_bone_counts[level];
    const int entries = palette_count_for_bones(character_->skeleton, bones);
    report_.bones_evaluated += agents_by_level[level] * static_cast<std::uint64_t>(bones);
    report_.palette_bytes += agents_by_level[level] * static_cast<std::uint64_t>(entries) * sizeof(PaletteMatrix);
  }
}

void AnimationSystem::end_work() {
  for (const ProcessingUnit& unit : scheduler_->units()) {
    report_.copies.bytes_in += unit.activity().copies.bytes_in;
    report_.copies.bytes_out += unit.activity().copies.bytes_out;
    report_.copies.transfers += unit.activity().copies.transfers;
  }
  if (!options_.hash) return;
  for (const AgentWork& work : work_) {
    agent_hashes_[work.agent] = chain_hash(chain_hash(work.agent, frame_), agent_hashes_[work.agent]);
  }
  std::uint64_t sum = 0;
  for (const std::uint64_t hash : agent_hashes_) sum += hash;
  pose_hash_ = chain_hash(pose_hash_, sum);
}

double AnimationSystem::bytes_per_agent() const {
  std::size_t bytes = agents_.bytes() + agent_count() * (sizeof(Ticks) + sizeof(std::uint64_t));
  for (EntityPools::Kind kind = 0; kind < pools_.kind_count(); ++kind) bytes += pools_.pool(kind).memory().bytes_alive;
  return static_cast<double>(bytes) / std::max<double>(agent_count(), 1.0);
}

std::vector<KindMemory> AnimationSystem::memory() const {
  std::vector<KindMemory> kinds;
  for (EntityPools::Kind kind = 0; kind < pools_.kind_count(); ++kind) {
    kinds.push_back({.kind = pools_.layout(kind).kind->name,
                     .own = pools_.pool(kind).memory(),
                     .shared = pools_.shared_pool(kind).memory()});
  }
  return kinds;
}

std::span<const float> AnimationSystem::pose(std::uint32_t agent) const {
  const Handle root = agents_.program(agent).root();
  const std::size_t floats = pose_bytes(context_.assets.bone_count, context_.assets.components) / sizeof(float);
  return {transforms_of(pools_.as<AnimationStateHeader>(root)), floats};
}

}  // namespace throng::anim
