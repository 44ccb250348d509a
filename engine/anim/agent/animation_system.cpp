#include "engine/anim/agent/animation_system.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string>
#include <utility>

#include "engine/anim/run/program/stream_reads.h"
#include "engine/anim/run/store/store_choice.h"

namespace throng::anim {
namespace {

Residency residency_for(Schedule schedule) {
  return schedule == Schedule::fused ? Residency::transient : Residency::resident;
}

}  // namespace

AnimationSystem::~AnimationSystem() = default;

Result<std::unique_ptr<AnimationSystem>> AnimationSystem::create(std::shared_ptr<const Character> character,
                                                                 const SystemOptions& options) {
  std::unique_ptr<AnimationSystem> system(new AnimationSystem());
  system->casts_.push_back(std::make_unique<Cast>(std::move(character)));
  const Status configured = system->configure(options);
  if (!configured) return configured.error();
  return system;
}

Result<std::uint32_t> AnimationSystem::add_character(std::shared_ptr<const Character> character) {
  if (casts_.size() == most_skeletons) {
    return Error{"a system animates at most " + std::to_string(most_skeletons) + " characters: use another one for \"" +
                 character->skeleton.name + "\""};
  }
  casts_.push_back(std::make_unique<Cast>(std::move(character)));
  const Status configured = configure(options_);
  if (configured) return static_cast<std::uint32_t>(casts_.size()) - 1;
  casts_.pop_back();
  refresh_contexts();
  return configured.error();
}

Status AnimationSystem::replace_character(std::uint32_t character, std::shared_ptr<const Character> reordered,
                                          std::span<const int> places) {
  Cast& cast = *casts_[character];
  if (const std::string bound = cast.bound_to_bone_order(); !bound.empty()) {
    return Error{"the bones of \"" + cast.skeleton().name + "\" keep their order: its agents have " + bound};
  }
  const std::shared_ptr<const Character> before = cast.replace_character(std::move(reordered));
  Status configured = configure(options_);
  if (configured) {
    cast.reorder_kept_transforms(places);
    return configured;
  }
  cast.replace_character(before);
  refresh_contexts();
  return configured;
}

void AnimationSystem::refresh_contexts() {
  const Kernels& kernels = options_.kernels == nullptr ? best_kernels() : *options_.kernels;
  contexts_.clear();
  for (const std::unique_ptr<Cast>& cast : casts_) {
    contexts_.push_back(cast->context(kernels));
    contexts_.back().assets.prefetch = options_.prefetch;
    if (cast->character->hierarchy.packs()) contexts_.back().palette_format = options_.palettes;
  }
}

LocalStoreDemand AnimationSystem::demand(const SystemOptions& options) const {
  LocalStoreDemand demand = local_store_demand(casts_, options.stream);
  demand.schedule = options.schedule;
  demand.double_buffering = options.double_buffering;
  return demand;
}

void AnimationSystem::convert(Schedule schedule, StreamKind stream) {
  for (const std::unique_ptr<Cast>& cast : casts_) {
    cast->set_residency(residency_for(schedule));
    cast->set_stream(stream);
  }
}

Status AnimationSystem::configure(const SystemOptions& options) {
  convert(options.schedule, options.stream);
  refresh_contexts();
  const LocalStoreDemand needs = demand(options);
  const std::size_t store_bytes =
      options.local_store_bytes == 0 ? automatic_local_store(contexts_, needs) : options.local_store_bytes;
  const Result<LocalStorePlan> plan = plan_local_store(contexts_, needs, store_bytes, options.tile);
  if (!plan) {
    convert(options_.schedule, options_.stream);
    return plan.error();
  }
  if (options.executor != nullptr) {
    threads_.reset();
  } else if (threads_ == nullptr || options.pus != options_.pus) {
    threads_ = std::make_unique<PuThreads>(options.pus);
  }
  options_ = options;
  for (const std::unique_ptr<Cast>& cast : casts_) cast->reserve_fades(options.stream, cast->agents.count());
  refresh_contexts();
  make_scheduler(*plan, store_bytes);
  return Done{};
}

void AnimationSystem::make_scheduler(const LocalStorePlan& plan, std::size_t store_bytes) {
  std::size_t most_entries = 0;
  for (const std::unique_ptr<Cast>& cast : casts_) {
    most_entries = std::max(most_entries, static_cast<std::size_t>(cast->skeleton().palette_count()));
  }
  scheduler_ = std::make_unique<Scheduler>(ScheduleOptions{.schedule = options_.schedule,
                                                           .double_buffering = options_.double_buffering,
                                                           .plan = plan,
                                                           .local_store_bytes = store_bytes,
                                                           .pus = options_.pus,
                                                           .cost = options_.cost,
                                                           .stores = store_policy(),
                                                           .trace = options_.trace},
                                           most_entries);
  scheduler_->reserve(agent_count());
  exact_scheduler_.reset();
}

void AnimationSystem::set_agent_count(std::uint32_t agents) {
  if (agents == 0) {
    for (const std::unique_ptr<Cast>& cast : casts_) cast->agents.resize(0);
  } else {
    assert(casts_.front()->agents.count() == agent_count() && "agents of several characters: use add_agents");
    casts_.front()->reserve_fades(options_.stream, agents);
    casts_.front()->agents.resize(agents);
  }
  for (std::uint32_t agent = agent_count(); agent < agents; ++agent) members_.push_back({.cast = 0, .local = agent});
  members_.resize(agents);
  reserve_work();
}

std::uint32_t AnimationSystem::add_agents(std::uint32_t count, std::uint32_t character) {
  const std::uint32_t first = agent_count();
  for (std::uint32_t i = 0; i < count; ++i) members_.push_back({character, casts_[character]->agents.count() + i});
  make_agents(first);
  return first;
}

std::uint32_t AnimationSystem::add_agents(std::span<const std::uint8_t> characters) {
  const std::uint32_t first = agent_count();
  std::array<std::uint32_t, most_skeletons> next{};
  for (std::size_t cast = 0; cast < casts_.size(); ++cast) next[cast] = casts_[cast]->agents.count();
  members_.reserve(first + characters.size());
  for (const std::uint8_t character : characters) members_.push_back({character, next[character]++});
  make_agents(first);
  return first;
}

// For the members from `first` on, each cast's all at once.
void AnimationSystem::make_agents(std::uint32_t first) {
  std::array<std::uint32_t, most_skeletons> added{};
  for (const Member& member : std::span(members_).subspan(first)) ++added[member.cast];
  for (std::size_t i = 0; i < casts_.size(); ++i) {
    if (added[i] == 0) continue;
    Cast& cast = *casts_[i];
    const std::uint32_t count = cast.agents.count() + added[i];
    cast.reserve_fades(options_.stream, count);
    cast.agents.resize(count);
  }
  reserve_work();
}

void AnimationSystem::restart() {
  assert(agent_count() == 0 && "agents stand at times of the old clock");
  clock_ = 0;
  frame_ = 0;
  pose_hash_ = 0;
  shared_posed_at_ = 0;
}

StorePolicy AnimationSystem::store_policy() const {
  if (options_.stores) return *options_.stores;
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < casts_.size(); ++i) bytes += casts_[i]->palette_bytes(contexts_[i].palette_format);
  return store_policy_for(bytes);
}

void AnimationSystem::reserve_work() {
  posed_at_.resize(agent_count(), clock_);
  agent_hashes_.resize(agent_count(), 0);
  work_.reserve(agent_count());
  runs_.reserve(agent_count());
  scheduler_->reserve(agent_count());
  scheduler_->set_stores(store_policy());
}

EntityBuilder AnimationSystem::builder(std::uint32_t agent) {
  return {cast(agent).pools,
          cast(agent).clips,
          {.owner = local(agent), .now = clock_, .posed_at = posed_at_[agent], .stream = options_.stream}};
}

int AnimationSystem::add_mask(BoneMask mask, std::uint32_t character) {
  const int index = casts_[character]->add_mask(std::move(mask));
  refresh_contexts();
  return index;
}

std::uint32_t AnimationSystem::add_bone_selection(BoneSelection selection, std::uint32_t character) {
  const std::uint32_t index = casts_[character]->add_selection(std::move(selection));
  refresh_contexts();
  return index;
}

bool AnimationSystem::play(std::uint32_t agent, const PlayRequest& request) {
  assert(request.mask >= PlayRequest::no_mask && request.mask < static_cast<int>(cast(agent).masks.size()) &&
         "PlayRequest::mask is not one that add_mask returned");
  const EntityBuilder build = builder(agent);
  if (agents(agent).channel_count(local(agent)) == 0) {
    [[maybe_unused]] const Status added =
        agents(agent).add_channel(build, local(agent), std::make_unique<CrossFadeChannel>(), {});
    assert(added && "a channel that plays nothing yet");
  }
  assert(dynamic_cast<CrossFadeChannel*>(&agents(agent).channel(local(agent), 0)) != nullptr &&
         "another kind of channel was added");
  auto& channel = static_cast<CrossFadeChannel&>(agents(agent).channel(local(agent), 0));
  const bool taken = channel.play(build, request);
  if (settle(agent, [&] { return agents(agent).rebuild(build, local(agent)); })) return taken;
  PlayRequest at_once = request;
  at_once.fade = 0;
  at_once.held_fraction.reset();
  at_once.mask = PlayRequest::no_mask;
  channel.play(build, at_once);
  [[maybe_unused]] const Status cut = settle(agent, [&] { return agents(agent).rebuild(build, local(agent)); });
  assert(cut && "a player alone is the least that there can be");
  return false;
}

void AnimationSystem::set_speed(std::uint32_t agent, double speed) {
  static_cast<CrossFadeChannel&>(agents(agent).channel(local(agent), 0)).set_speed(builder(agent), speed);
}

Status AnimationSystem::add_channel(std::uint32_t agent, std::unique_ptr<Channel> channel,
                                    const LayerSettings& settings) {
  const EntityBuilder build = builder(agent);
  Status added =
      settle(agent, [&] { return agents(agent).add_channel(build, local(agent), std::move(channel), settings); });
  if (!added) agents(agent).remove_channel(build, local(agent), agents(agent).channel_count(local(agent)) - 1);
  return added;
}

void AnimationSystem::remove_channel(std::uint32_t agent, std::size_t channel) {
  agents(agent).remove_channel(builder(agent), local(agent), channel);
}

Status AnimationSystem::add_post_process(std::uint32_t agent, std::unique_ptr<PostProcess> process) {
  const EntityBuilder build = builder(agent);
  Status added = settle(agent, [&] { return agents(agent).add_post_process(build, local(agent), std::move(process)); });
  if (!added)
    agents(agent).remove_post_processes(build, local(agent), agents(agent).post_process_count(local(agent)) - 1);
  return added;
}

Status AnimationSystem::process_changed(std::uint32_t agent, std::size_t index) {
  Status changed =
      settle(agent, [&] { return agents(agent).update_post_process(builder(agent), local(agent), index); });
  if (changed) return changed;
  agents(agent).post_process(local(agent), index).destroy_entities(builder(agent));
  [[maybe_unused]] const Status rebuilt = agents(agent).rebuild(builder(agent), local(agent));
  assert(rebuilt && "it did before");
  return changed;
}

void AnimationSystem::remove_post_processes(std::uint32_t agent) {
  agents(agent).remove_post_processes(builder(agent), local(agent));
}

std::unique_ptr<PostProcess> AnimationSystem::take_last_post_process(std::uint32_t agent) {
  return agents(agent).take_last_post_process(builder(agent), local(agent));
}

void AnimationSystem::set_channel_weight(std::uint32_t agent, std::size_t channel, float weight) {
  agents(agent).set_weight(local(agent), channel, weight);
}

// What an agent asks of the local store after a change may be more than any did before.
Status AnimationSystem::fit(std::uint32_t agent) {
  const StoreNeeds& needs = program(agent).needs;
  if (plan_holds(schedule().plan, contexts_[cast_of(agent)], options_.schedule, needs)) return Done{};
  return fit_stores(demand(options_));
}

Status AnimationSystem::fit_stores(const LocalStoreDemand& needs) {
  std::size_t bytes = schedule().local_store_bytes;
  if (options_.local_store_bytes == 0) bytes = std::max(bytes, automatic_local_store(contexts_, needs));
  const Result<LocalStorePlan> plan = plan_local_store(contexts_, needs, bytes, options_.tile);
  if (!plan) return plan.error();
  if (bytes == schedule().local_store_bytes) {
    scheduler_->set_plan(*plan);
  } else {
    make_scheduler(*plan, bytes);
  }
  return Done{};
}

EntityBuilder AnimationSystem::shared_builder(Cast& cast, std::uint32_t graph) {
  return {cast.pools,
          cast.clips,
          {.owner = shared_owner | graph, .now = clock_, .posed_at = shared_posed_at_, .stream = options_.stream}};
}

Result<Handle> AnimationSystem::add_shared(std::unique_ptr<Channel> channel, std::uint32_t character) {
  Cast& cast = *casts_[character];
  const std::uint32_t graph = cast.shared.count();
  cast.shared.resize(graph + 1);
  Status added = cast.shared.add_channel(shared_builder(cast, graph), graph, std::move(channel), {});
  if (added && cast.shared.graph(graph).empty()) added = Error{"a shared channel must play something"};
  if (added) added = fit_stores(demand(options_));
  if (!added) {
    cast.shared.resize(graph);
    return added.error();
  }
  return cast.shared.graph(graph).root();
}

double AnimationSystem::bytes_per_agent() const {
  std::size_t bytes = agent_count() * (sizeof(Member) + sizeof(Ticks) + sizeof(std::uint64_t));
  for (const std::unique_ptr<Cast>& cast : casts_) bytes += cast->bytes_alive();
  return static_cast<double>(bytes) / std::max<double>(agent_count(), 1.0);
}

std::uint64_t AnimationSystem::stream_bytes() const {
  std::uint64_t bytes = 0;
  for (const std::span<const AgentWork> all : {std::span(shared_work_), std::span(work_)}) {
    for (const AgentWork& work : all) bytes += stream_bytes_read(contexts_[work.skeleton], work);
  }
  return bytes;
}

std::vector<KindMemory> AnimationSystem::memory() const {
  std::vector<KindMemory> kinds;
  for (const std::unique_ptr<Cast>& cast : casts_) cast->add_memory(kinds);
  return kinds;
}

std::span<const float> AnimationSystem::pose(std::uint32_t agent) const {
  const auto& state = pools(agent).as<AnimationStateHeader>(graph(agent).root());
  return {transforms_of(state), pose_bytes(state.bone_count, state.components) / sizeof(float)};
}

}  // namespace throng::anim
