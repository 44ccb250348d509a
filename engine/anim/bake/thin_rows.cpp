#include "engine/anim/bake/thin_rows.h"

#include <algorithm>
#include <cassert>
#include <span>

namespace throng::anim {

namespace {

/// Poses are compared at so many instants of a step.
constexpr int probes_of_step = 2;

/// Says whether the rows between two can be left out.
class GapMeter {
 public:
  GapMeter(const SampleSource& source, const SampledRows& rows, const SampledStream& stream, double allowed)
      : source_(source),
        stream_(stream),
        aligned_(rows),
        allowed_(allowed),
        exact_(source.exact),
        poses_(stream),
        sampled_(source.skeleton.bones.size()) {
    for (KnownFrames& known : known_) known.frames.resize(source.skeleton.bones.size());
  }

  /// Two rows that are neighbours always fit.
  bool fits(int row, int gap) {
    if (gap == 1) return true;
    if (aligned_.turns_too_far(row, row + gap)) return false;
    const int probes = gap * probes_of_step;
    // From the middle outwards, where most is off.
    for (int i = 0; i < probes - 1; ++i) {
      const int probe = probes / 2 + (i % 2 == 0 ? i / 2 : -(i / 2 + 1));
      if (distance(row, gap, probe) > allowed_) return false;
    }
    return true;
  }

 private:
  struct KnownFrames {
    int probe = -1;
    std::vector<BoneFrame> frames;
  };

  double distance(int row, int gap, int probe) {
    const int fraction = sample_fraction_one * probe / (gap * probes_of_step);
    const SamplePoint point{stream_.row(row), stream_.row(row + gap), row_weights(fraction)};
    compute_frames(source_.skeleton, poses_.at(point), sampled_);
    return largest_distance(source_.proxy, exact_frames(row * probes_of_step + probe), sampled_);
  }

  /// Computes each once: known_ has room for all that the longest gap looks at.
  std::span<const BoneFrame> exact_frames(int probe) {
    KnownFrames& known = known_[static_cast<std::size_t>(probe) % std::size(known_)];
    if (known.probe != probe) {
      known.probe = probe;
      const Ticks time = stream_.first_row + Ticks{std::int64_t{stream_.step_ticks} * probe / probes_of_step};
      compute_frames(source_.skeleton, exact_.at(std::clamp(time, Ticks{}, stream_.duration)), known.frames);
    }
    return known.frames;
  }

  const SampleSource& source_;
  const SampledStream& stream_;
  AlignedRows aligned_;
  double allowed_;
  ExactPoses exact_;
  SampledPoses poses_;
  std::vector<BoneFrame> sampled_;
  KnownFrames known_[most_steps_between_rows * probes_of_step];
};

}  // namespace

std::vector<std::uint8_t> thin_rows(const SampleSource& source, const SampledRows& rows, const SampledStream& stream,
                                    double allowed) {
  assert(rows.gaps.empty() && rows.row_count == stream.row_count);
  GapMeter meter(source, rows, stream, allowed);
  std::vector<std::uint8_t> gaps;
  int gap = 1;
  for (int row = 0; row + 1 < rows.row_count; row += gap) {
    const int longest = std::min(most_steps_between_rows, rows.row_count - 1 - row);
    gap = std::min(gap, longest);
    if (meter.fits(row, gap)) {
      while (gap < longest && meter.fits(row, gap + 1)) ++gap;
    } else {
      do --gap;
      while (!meter.fits(row, gap));
    }
    gaps.push_back(static_cast<std::uint8_t>(gap));
  }
  return gaps;
}

}  // namespace throng::anim
