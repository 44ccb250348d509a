#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/run/fused/clip_strip.h"

namespace throng::app {

/// The two clips that an agent of a benchmark plays for good, each from its own phase, and the weight of the second.
struct BenchAgent {
  static constexpr int none = -1;  ///< instead of a second clip

  int from_clip, to_clip;
  Ticks from_start, to_start;
  float fraction;
};

/// Returns a pair of clips, phases and a weight for each agent; they are the same each time.
std::vector<BenchAgent> bench_agents(const anim::Character& character, int agents);

/// The palette slots of a crowd, one an agent, 64-byte aligned, as a renderer would hand them out.
class BenchPalettes {
 public:
  BenchPalettes(int agents, int entries, PaletteFormat format = PaletteFormat::matrices);
  PaletteFormat format() const { return format_; }
  std::byte* of(std::size_t agent) const { return memory_.get() + agent * slot_bytes_; }
  std::span<float> floats() const { return {reinterpret_cast<float*>(memory_.get()), size_ / sizeof(float)}; }

 private:
  PaletteFormat format_;
  std::size_t slot_bytes_;
  std::size_t size_;
  anim::AlignedBytes memory_;
};

/// The whole update: system, scheduler, local stores, kernels.
class SystemSubject {
 public:
  static Result<SystemSubject> create(std::shared_ptr<const anim::Character> character,
                                      const anim::SystemOptions& options, std::span<const BenchAgent> agents,
                                      const BenchPalettes& palettes);
  void run();
  /// Sets the time that passes from one run to the next; 1/60 s unless set.
  void set_step(Ticks step) { step_ = step; }
  /// Returns [agent] what a run asks for, to ask for more.
  std::span<PoseRequest> updates() { return updates_; }
  /// Changes to other options, which must fit.
  void configure(const anim::SystemOptions& options);
  void record_trace(anim::Tracing tracing) { system_->record_trace(tracing); }
  const anim::AnimationSystem& system() const { return *system_; }
  anim::AnimationSystem& system() { return *system_; }

 private:
  std::unique_ptr<anim::AnimationSystem> system_;
  Ticks step_ = ticks_per_second / 60;
  std::vector<PoseRequest> updates_;
};

/// The bare kernels over the same agents: clips to palettes of their format, one thread, no blocks and no copies.
class KernelSubject {
 public:
  KernelSubject(const anim::Character& character, const anim::Kernels& kernels, std::span<const BenchAgent> agents,
                const BenchPalettes& palettes);
  void run();

 private:
  void run_strip(std::span<const BenchAgent> agents, std::size_t first);
  anim::ClipMoment moment(int clip_index, Ticks start) const;
  void find_moments(std::span<const BenchAgent> agents);

  const anim::Character* character_;
  const anim::Kernels* kernels_;
  std::span<const BenchAgent> agents_;
  const BenchPalettes* palettes_;
  std::vector<Ticks> clocks_;                                   ///< [clip] the time within it
  std::array<anim::ClipMoment, anim::widest_strip> from_, to_;  ///< the moments of the strip that is posed
  std::array<anim::ShownClips, anim::widest_strip> shown_;
  anim::ClipStrip clips_;  ///< the clips of these moments
  anim::StorePolicy stores_;
  anim::AlignedBytes scratch_;
  float* local_;
  float* carry_;
  float* branches_;
};

}  // namespace throng::app
