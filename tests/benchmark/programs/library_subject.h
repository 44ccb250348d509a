#pragma once

#include <algorithm>
#include <span>

#include "app/commands/bench/crowd.h"

namespace throng::app {

/// A crowd of the same agents, clips, times and weights that another library animates on one thread: two samplings, a
/// blend, model space, palettes.
class LibrarySubject {
 public:
  virtual ~LibrarySubject() = default;
  /// Poses every agent, 1/60 s after the last time.
  void run() {
    advance();
    for (std::size_t agent = 0; agent < agents_.size(); ++agent) pose(agent);
  }

  /// Returns the bytes that the library keeps all clips in.
  virtual std::size_t bytes() const = 0;

 protected:
  LibrarySubject(std::span<const BenchAgent> agents, const BenchPalettes& palettes)
      : agents_(agents), palettes_(&palettes) {}
  virtual void pose(std::size_t agent) = 0;

  void advance() { clock_ += ticks_per_second / 60; }
  std::span<const BenchAgent> agents() const { return agents_; }
  /// Returns the time within a clip that began at `start` and loops.
  Ticks time_in_clip(Ticks start, Ticks duration) const { return (start + clock_) % std::max(duration, Ticks{1}); }
  anim::PaletteMatrix* palette_of(std::size_t agent) const {
    return reinterpret_cast<anim::PaletteMatrix*>(palettes_->of(agent).memory());
  }

 private:
  std::span<const BenchAgent> agents_;
  const BenchPalettes* palettes_;
  Ticks clock_{};
};

}  // namespace throng::app
