#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/anim/agent/blend_trees.h"
#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/asset/character.h"
#include "engine/anim/base/result.h"
#include "engine/anim/run/pu_threads.h"
#include "engine/anim/run/scheduler.h"

namespace throng::anim {

struct SystemOptions {
  int pus = 1;                        ///< 1 to max_pus
  std::size_t local_store_bytes = 0;  ///< of each PU; 0: automatic, see automatic_local_store
  int tile = 0;                       ///< characters a tile: 1, 2, 4, 8, 16; 0: what fits
  Schedule schedule = Schedule::fused;
  /// Who runs the PUs: a host's job system, which outlives the system; null: threads of the system's own.
  Executor* executor = nullptr;
  DoubleBuffering double_buffering = DoubleBuffering::interleaved;
  StreamKind stream = StreamKind::sampled;
  bool hash = true;                  ///< hash every palette that is written
  const Kernels* kernels = nullptr;  ///< null: the best that this machine runs

  friend bool operator==(const SystemOptions&, const SystemOptions&) = default;
};
inline constexpr int max_pus = 256;

/// One agent to be posed in this frame.
struct AgentUpdate {
  std::uint32_t agent = 0;
  std::uint8_t level = 0;            ///< bone level
  Ticks look_ahead = 0;              ///< the pose is that of now + look_ahead (smooth skipping)
  PaletteMatrix* palette = nullptr;  ///< where the PU writes it, room for the level's entries; null: nobody draws it
};

/// What the last update did.
struct UpdateReport {
  std::uint32_t agents_updated = 0;
  std::uint64_t bones_evaluated = 0;
  std::uint64_t palette_bytes = 0;
  CopyCounts copies;
};

/// The façade (paper 2.1.2): a crowd of agents that share one character. Requests between frames, then a frame:
///     advance(dt)       the clock of every agent, updated or not
///     update(agents)    poses those that level of detail chose, on all PUs; returns when they are done
/// One thread; the PUs are inside.
class AnimationSystem {
 public:
  static Result<std::unique_ptr<AnimationSystem>> create(std::shared_ptr<const Character> character,
                                                         const SystemOptions& options);
  ~AnimationSystem();

  /// At a frame boundary. Poses do not depend on any of the options but the stream. On error nothing has changed.
  Status configure(const SystemOptions& options);

  /// New agents play nothing until asked; every agent must play something before it is updated.
  void set_agent_count(std::uint32_t agents);
  std::uint32_t agent_count() const { return trees_.agent_count(); }

  /// Per-bone weights for requests, to be added at load time; the index for `PlayRequest::mask`. The mask was made for
  /// this character's skeleton.
  int add_mask(BoneMask mask);

  /// False: too many fades run already; ask again later. Blends that stay (masked or held) count until they are
  /// replaced. Room for one fade of every agent is set aside; where more run at once, this adds a slab of blocks.
  bool play(std::uint32_t agent, const PlayRequest& request);

  void advance(Ticks delta) { clock_ += delta; }
  Ticks clock() const { return clock_; }
  void update(std::span<const AgentUpdate> agents);

  const UpdateReport& report() const { return report_; }
  std::span<const ProcessingUnit> units() const { return scheduler_->units(); }
  const ScheduleOptions& schedule() const { return scheduler_->options(); }
  const SystemOptions& options() const { return options_; }
  const Kernels& kernels() const { return *context_.assets.kernels; }
  const Character& character() const { return *character_; }
  /// Over the palettes of all updates so far: an agent's is seeded by agent and frame, summed over agents, chained.
  std::uint64_t pose_hash() const { return pose_hash_; }
  /// Main memory of an agent, without palettes: blocks and bookkeeping.
  double bytes_per_agent() const;

  /// The last pose of an agent, [packet][components][16], state space. Only `levels` keeps it (resident blocks).
  std::span<const float> pose(std::uint32_t agent) const;

 private:
  AnimationSystem(std::shared_ptr<const Character> character);
  LocalStoreDemand demand(const SystemOptions& options) const;
  Executor& executor() const { return threads_ == nullptr ? *options_.executor : *threads_; }
  void begin_work(std::span<const AgentUpdate> agents);
  void end_work();

  std::shared_ptr<const Character> character_;
  SystemOptions options_;
  std::vector<ClipStreams> clips_;
  std::vector<BoneMask> masks_;
  std::vector<const float*> mask_weights_;  // of masks_, as the context lists them
  EntityPools pools_;
  BlendTrees trees_;
  UpdateContext context_;
  std::unique_ptr<Scheduler> scheduler_;
  std::unique_ptr<PuThreads> threads_;  // null where a host's executor runs the PUs

  Ticks clock_ = 0;
  std::uint64_t frame_ = 0;
  std::uint64_t pose_hash_ = 0;
  std::vector<Ticks> posed_at_;              // one an agent: the time its entities stand at
  std::vector<std::uint64_t> agent_hashes_;  // one an agent: of its last update
  std::vector<AgentWork> work_;
  UpdateReport report_;
};

}  // namespace throng::anim
