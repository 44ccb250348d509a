#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/anim/agent/agents.h"
#include "engine/anim/agent/cast.h"
#include "engine/anim/agent/cross_fade_channel.h"
#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/base/result.h"
#include "engine/anim/run/pu_threads.h"
#include "engine/anim/run/scheduler.h"

namespace throng::anim {

struct SystemOptions {
  int pus = 1;                        ///< 1 to max_pus
  std::size_t local_store_bytes = 0;  ///< of each PU; 0: automatic (automatic_local_store), grows with the graphs
  int tile = 0;                       ///< characters a tile: 1, 2, 4, 8, 16; 0: what fits, up to 32
  Schedule schedule = Schedule::fused;
  /// Who runs the PUs: a host's job system, which outlives the system; null: threads of the system's own.
  Executor* executor = nullptr;
  DoubleBuffering double_buffering = DoubleBuffering::interleaved;
  StreamKind stream = StreamKind::sampled;
  bool hash = true;             ///< hash every palette that is written
  Tracing trace = Tracing::on;  ///< record what each PU does, for units() and update_time()
  bool prefetch = false;        ///< players ask for their rows before the first packet is sampled (paper, note 5)
  CostModel cost{};             ///< what orders tasks and cuts tiles
  std::optional<StorePolicy> stores{};  ///< how palettes are written; none: by their size (run/store/store_choice.h)
  /// What is written: `packed` of the characters that can be packed (see palette_format), matrices of all others.
  PaletteFormat palettes = PaletteFormat::matrices;
  const Kernels* kernels = nullptr;  ///< null: the best that this machine runs

  friend bool operator==(const SystemOptions&, const SystemOptions&) = default;
};
inline constexpr int max_pus = 256;

/// One agent to be posed in this frame.
struct AgentUpdate {
  std::uint32_t agent = 0;
  std::uint8_t level = 0;           ///< bone level
  Ticks look_ahead = 0;             ///< the pose is that of now + look_ahead (smooth skipping); see can_wind_back()
  PaletteDestination palette = {};  ///< where the PU writes it, room for the level's entries; null: nobody draws it
  /// On the way to or from a coarser level: the bones that it lacks are so many halves of the way to where they stand
  /// still. At 2 the palette shows what that level shows, so that meshes can change without a pop.
  std::uint8_t fade_level = 0;
  std::uint8_t fade_halves = 0;  ///< 0 to 2
};

/// One agent whose exact pose is wanted.
struct ExactPose {
  std::uint32_t agent = 0;
  PaletteMatrix* palette = nullptr;  ///< out, room for all entries of its skeleton; 64-byte aligned
};

/// What the last update did.
struct UpdateReport {
  std::uint32_t agents_updated = 0;
  std::uint64_t bones_evaluated = 0;
  std::uint64_t palette_bytes = 0;
  double predicted_nanoseconds = 0;  ///< of one PU, by SystemOptions::cost: agents, and tiles as wide as they come
  CopyCounts copies;
};

/// A crowd as it was: the bytes of its blocks, and what its agents remember. See AnimationSystem::snapshot.
class SystemSnapshot;

/// The façade (paper 2.1.2): a crowd of agents, mostly of one character, of several if they are added. Requests between
/// frames, then a frame:
///     advance(dt)       the clock of every agent, updated or not
///     update(agents)    poses those that level of detail chose, on all PUs; returns when they are done
/// One thread; the PUs are inside.
class AnimationSystem {
 public:
  static Result<std::unique_ptr<AnimationSystem>> create(std::shared_ptr<const Character> character,
                                                         const SystemOptions& options);
  ~AnimationSystem();

  /// At a frame boundary. Poses do not depend on any of the options but the stream; the hash of what is written also
  /// depends on the format of palettes. On error nothing has changed.
  Status configure(const SystemOptions& options);

  /// Another character (a camera and a prop are characters too), at load time: its number for add_agents and for what
  /// belongs to a skeleton. The one of create() is 0. On error (the local store is too small
  /// for it, or there are most_skeletons already) nothing has changed.
  Result<std::uint32_t> add_character(std::shared_ptr<const Character> character);

  /// The same character with its bones in another order (asset/skeleton_order.h) and other levels, at a frame boundary:
  /// agents go on where they are. `places`: the new index of each bone. Rigs that kinds of entities point at are the
  /// host's to reorder, at once (CharacterRigs::reorder_bones). Errors, and then nothing has changed: masks, selections
  /// or inertialisers hold on to the order; the local store is too small. Older snapshots cannot be restored.
  Status replace_character(std::uint32_t character, std::shared_ptr<const Character> reordered,
                           std::span<const int> places);

  /// New agents play nothing until asked; every agent must play something before it is updated.
  void set_agent_count(std::uint32_t agents);
  /// `count` more agents of a character, numbered on from those that there are: the first one's number. Afterwards
  /// set_agent_count can only be told 0.
  std::uint32_t add_agents(std::uint32_t count, std::uint32_t character);
  /// One more agent of each of these characters, in this order: the first one's number.
  std::uint32_t add_agents(std::span<const std::uint8_t> characters);
  /// Of the palettes of a character's agents.
  PaletteFormat palette_format(std::uint32_t character) const { return contexts_[character].palette_format; }
  /// Which character the agent is, as add_agents was told.
  std::uint32_t character_number(std::uint32_t agent) const { return members_[agent].cast; }
  std::uint32_t agent_count() const { return static_cast<std::uint32_t>(members_.size()); }

  /// Per-bone weights for requests and layers, to be added at load time; the index for `PlayRequest::mask`. The mask
  /// was made for this character's skeleton.
  int add_mask(BoneMask mask, std::uint32_t character = 0);

  /// Bones that a player evaluates, the others standing still (paper 3.2, per-bone priorities); for
  /// `PlayRequest::bone_selection`. Made for this character's skeleton, added at load time.
  std::uint32_t add_bone_selection(BoneSelection selection, std::uint32_t character = 0);

  /// A kind of entity of the host's own, to be added at load time: for channels and post processes that make such
  /// entities. `kind` outlives the system.
  EntityPools::Kind add_entity_kind(const EntityKind& kind, std::uint32_t character = 0) {
    return casts_[character]->pools.add_kind(kind);
  }
  /// Memory for `count` living entities of a kind: as long as there are no more, making one allocates nothing.
  void reserve_entities(EntityPools::Kind kind, std::size_t count, std::uint32_t character = 0) {
    casts_[character]->pools.pool(kind).reserve(count);
  }

  /// Plays a clip on the agent's first channel, which is a CrossFadeChannel unless another was added first. False: all
  /// places of the channel's tree are taken by blends that stay (masked or held); or a local store of fixed size has no
  /// room for the fade, and the clip replaced all at once.
  bool play(std::uint32_t agent, const PlayRequest& request);

  /// Plays what the agent asked for last at another speed from now on, without a jump. The first channel is as for
  /// play.
  void set_speed(std::uint32_t agent, double speed);

  /// Lays a channel over those that the agent has. Errors, and then the agent is as it was: its graph has a cycle, or
  /// is too large for a local store of fixed size.
  Status add_channel(std::uint32_t agent, std::unique_ptr<Channel> channel, const LayerSettings& settings = {});
  /// The channels after it move up one place.
  void remove_channel(std::uint32_t agent, std::size_t channel);
  /// The agent's pose passes through it, after those that were added before. Errors as for add_channel.
  Status add_post_process(std::uint32_t agent, std::unique_ptr<PostProcess> process);
  void remove_post_processes(std::uint32_t agent);
  /// The last of at least one, without its entities, to be given to another agent of the same character.
  std::unique_ptr<PostProcess> take_last_post_process(std::uint32_t agent);

  /// A graph that is updated once a frame, to the clock and before all agents, for agents to read: the entity whose
  /// state it is, a source for what their channels make. Lives as long as the system. The channel may change its
  /// parameters by itself, but its state() stays the same entity. Agents that read it are posed without look-ahead, and
  /// its players keep the stream that they were made for. Errors: as for add_channel.
  Result<Handle> add_shared(std::unique_ptr<Channel> channel, std::uint32_t character = 0);

  /// Of a channel but the first, over those before it.
  void set_channel_weight(std::uint32_t agent, std::size_t channel, float weight);

  std::size_t channel_count(std::uint32_t agent) const { return agents(agent).channel_count(local(agent)); }
  const Channel& channel(std::uint32_t agent, std::size_t index) const {
    return agents(agent).channel(local(agent), index);
  }
  /// Sets parameters of a channel, which is then updated: system.change<BlendSpaceChannel>(agent, 0, [&](auto& walk) {
  /// walk.set_parameter(speed); }).
  template <typename Derived, typename Change>
  Status change(std::uint32_t agent, std::size_t index, Change&& change_parameters) {
    change_parameters(static_cast<Derived&>(agents(agent).channel(local(agent), index)));
    return settle(agent, [&] { return agents(agent).update(builder(agent), local(agent)); });
  }

  std::size_t post_process_count(std::uint32_t agent) const { return agents(agent).post_process_count(local(agent)); }
  template <typename Derived>
  const Derived& post_process(std::uint32_t agent, std::size_t index) const {
    return static_cast<const Derived&>(agents(agent).post_process(local(agent), index));
  }
  /// Sets parameters of a post process, which alone is then updated: system.change_process<LookAtProcess>(agent, 0,
  /// [&](auto& look) { look.look_at(target); }). On error the process lets go of its entities.
  template <typename Derived, typename Change>
  Status change_process(std::uint32_t agent, std::size_t index, Change&& change_parameters) {
    change_parameters(static_cast<Derived&>(agents(agent).post_process(local(agent), index)));
    return process_changed(agent, index);
  }

  void advance(Ticks delta) { clock_ += delta; }
  Ticks clock() const { return clock_; }
  void update(std::span<const AgentUpdate> agents);

  /// Palettes of the clock, with all bones, of agents that were updated before: what level of detail is measured
  /// against. However far ahead an agent stands, its players and blends are wound back; what remembers more than a time
  /// (rag-dolls, gazes, placed feet) is taken as it is. Changes nothing: copies of blocks are updated and dropped.
  void pose_exactly(std::span<const ExactPose> agents);
  /// False while an agent stands ahead of the clock and its pose of now is not known: the offset of an interrupted fade
  /// was captured in between, or placed feet are being let go.
  bool can_pose_exactly(std::uint32_t agent) const;
  /// False while an agent stands ahead of the clock and some entity of it remembers more than a time (gazes, limbs that
  /// reach, held feet, rag-dolls, kinds of a host's own): update() leaves it where it stands.
  bool can_wind_back(std::uint32_t agent) const;

  /// Root motion, data keys and absolute root of an agent, at a frame boundary: after advance(), ask for the interval
  /// from the clock before to the clock now, before any request.
  AgentMotion motion(std::uint32_t agent) const {
    return {pools(agent), cast(agent).clips, graph(agent), posed_at_[agent]};
  }

  /// Block copies of everything that changes: a crowd that is restored goes on to the same poses, bit for bit. Reuses
  /// the snapshot's memory. Restoring is refused, and changes nothing, under a schedule whose blocks have other sizes.
  void snapshot(SystemSnapshot& into) const;
  Status restore(const SystemSnapshot& from);

  /// Moves living blocks together, in the order in which the scheduler reads them, and gives memory back.
  Compaction compact();

  /// Who runs the PUs: between updates it is free for the host's own jobs, at most options().pus at once.
  Executor& executor() const { return threads_ == nullptr ? *options_.executor : *threads_; }
  const UpdateReport& report() const { return report_; }
  /// Bytes of streams that the players of the last update read, however often several read the same (paper 2.2.3: the
  /// resource that stays shared). Of sampled streams the two rows around the time; of keyframe streams the share of
  /// their keys that the time passed over.
  std::uint64_t stream_bytes() const;
  std::span<const ProcessingUnit> units() const { return scheduler_->units(); }
  /// SystemOptions::trace, without making anything anew.
  void record_trace(Tracing tracing) {
    options_.trace = tracing;
    scheduler_->record_trace(tracing, agent_count());
  }
  const UpdateTime& update_time() const { return scheduler_->time(); }
  const ScheduleOptions& schedule() const { return scheduler_->options(); }
  const SystemOptions& options() const { return options_; }
  const Kernels& kernels() const { return *contexts_.front().assets.kernels; }
  /// Of the agent; the one of create() if there is no agent yet.
  const Character& character(std::uint32_t agent = 0) const { return *cast(agent).character; }
  const EntityPools& pools(std::uint32_t agent = 0) const { return cast(agent).pools; }
  const PoseGraph& graph(std::uint32_t agent) const { return cast(agent).agents.graph(local(agent)); }
  const PoseProgram& program(std::uint32_t agent) const { return *graph(agent).program; }
  /// Over the palettes of all updates so far: an agent's is seeded by agent and frame, summed over agents, chained.
  std::uint64_t pose_hash() const { return pose_hash_; }
  /// [agent] of its last update: what pose_hash() sums up.
  std::span<const std::uint64_t> agent_hashes() const { return agent_hashes_; }
  /// Clock, frames and pose hash begin anew, as if the system were new. There are no agents and no shared graphs.
  void restart();
  /// Main memory of an agent, without palettes: blocks and bookkeeping.
  double bytes_per_agent() const;
  /// In the order of the kinds; allocates.
  std::vector<KindMemory> memory() const;

  /// The last pose of an agent, [packet][components][16], state space. Only `levels` keeps it (resident blocks).
  std::span<const float> pose(std::uint32_t agent) const;

 private:
  friend class SystemSnapshot;

  /// Which character an agent plays, and its number among those that do.
  struct Member {
    std::uint32_t cast;
    std::uint32_t local;
  };

  AnimationSystem() = default;
  std::uint32_t cast_of(std::uint32_t agent) const { return agent < members_.size() ? members_[agent].cast : 0; }
  Cast& cast(std::uint32_t agent) { return *casts_[cast_of(agent)]; }
  const Cast& cast(std::uint32_t agent) const { return *casts_[cast_of(agent)]; }
  std::uint32_t local(std::uint32_t agent) const { return members_[agent].local; }
  Agents& agents(std::uint32_t agent) { return cast(agent).agents; }
  const Agents& agents(std::uint32_t agent) const { return cast(agent).agents; }
  EntityBuilder builder(std::uint32_t agent);
  EntityBuilder shared_builder(Cast& cast, std::uint32_t graph);
  void refresh_contexts();

  LocalStoreDemand demand(const SystemOptions& options) const;
  Status fit(std::uint32_t agent);
  /// Makes a change to an agent's graph, and fits the stores to what it then asks of them.
  template <typename Change>
  Status settle(std::uint32_t agent, Change&& change_graph) {
    const StoreNeeds before = program(agent).needs;
    Status changed = change_graph();
    return !changed || program(agent).needs == before ? changed : fit(agent);
  }
  Status fit_stores(const LocalStoreDemand& needs);
  void make_scheduler(const LocalStorePlan& plan, std::size_t store_bytes);
  void convert(Schedule schedule, StreamKind stream);
  Status process_changed(std::uint32_t agent, std::size_t index);
  void make_agents(std::uint32_t first);
  void reserve_work();

  void update_channels(std::uint32_t agent);
  void begin_shared_work();
  bool update_shared(Cast& cast);
  void begin_work(std::span<const AgentUpdate> agents);
  std::uint16_t predicted_cost(const PoseProgram& program, std::uint32_t cast, int level) const;
  bool exact_stores_hold() const;
  void make_exact_scheduler();
  StorePolicy store_policy() const;
  void report_work(const WorkOrder& order);
  void end_work();

  SystemOptions options_;
  std::vector<std::unique_ptr<Cast>> casts_;
  std::vector<UpdateContext> contexts_;  // [cast]
  std::vector<Member> members_;          // [agent]
  std::unique_ptr<Scheduler> scheduler_;
  std::unique_ptr<Scheduler> exact_scheduler_;  // null until it is needed, and after a change of what it would need
  std::unique_ptr<PuThreads> threads_;          // null where a host's executor runs the PUs

  Ticks clock_ = 0;
  std::uint64_t frame_ = 0;
  std::uint64_t pose_hash_ = 0;
  Ticks shared_posed_at_ = 0;
  std::vector<Ticks> posed_at_;              // [agent] the time its entities stand at
  std::vector<std::uint64_t> agent_hashes_;  // [agent] of its last update
  std::vector<AgentWork> work_;
  std::vector<WorkRun> runs_;  // in it
  std::vector<AgentWork> shared_work_;
  std::vector<AgentWork> exact_work_;
  std::vector<WorkRun> exact_runs_;
  std::vector<UpdateContext> exact_contexts_;  // as contexts_, palettes as matrices
  UpdateReport report_;
};

}  // namespace throng::anim
