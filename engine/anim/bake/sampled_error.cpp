#include "engine/anim/bake/sampled_error.h"

#include <algorithm>
#include <vector>

namespace throng::anim {

namespace {

/// Errors are measured at these fractions of a step: at its beginning, midway (CUBICSPLINE), and where a chord strays
/// most from its arc.
constexpr double probes[] = {0.0, 0.21, 0.5, 0.79};

/// Steps whose error comes this near to the largest are measured again at so many times.
constexpr double near_largest = 0.9;
constexpr int close_probes = 16;

/// The kernels round fractions between two rows, so that a pose may be early or late by so much of the way.
constexpr double fraction_rounding = 0.5 / sample_fraction_one;

/// Compares a sampled stream with the exact one on the surface.
class ErrorMeter {
 public:
  ErrorMeter(const SampleSource& source, const SampledStream& stream)
      : source_(source),
        stream_(stream),
        exact_(source.exact),
        poses_(stream),
        expected_(source.skeleton.bones.size()),
        sampled_(source.skeleton.bones.size()) {}

  double at(Ticks time) {
    const Ticks within = std::clamp(time, Ticks{}, stream_.duration);
    compute_frames(source_.skeleton, exact_.at(within), expected_);
    compute_frames(source_.skeleton, poses_.at(locate(stream_, within)), sampled_);
    return largest_distance(source_.proxy, expected_, sampled_);
  }

  /// Returns the distance that the exact surface moves from the time of the last call of this function.
  double motion_to(Ticks time) {
    compute_frames(source_.skeleton, exact_.at(std::clamp(time, Ticks{}, stream_.duration)), expected_);
    const double motion = last_.empty() ? 0.0 : largest_distance(source_.proxy, last_, expected_);
    last_ = expected_;
    return motion;
  }

  /// Measures at a part of the way through a step.
  double within(int step, double part) {
    const Ticks passed{static_cast<std::int64_t>(part * static_cast<double>(stream_.step_ticks))};
    return at(time_of(step) + passed);
  }
  Ticks time_of(int step) const { return stream_.first_row + step * Ticks{stream_.step_ticks}; }

 private:
  const SampleSource& source_;
  const SampledStream& stream_;
  ExactPoses exact_;
  SampledPoses poses_;
  std::vector<BoneFrame> expected_, sampled_, last_;
};

}  // namespace

double measure_error(const SampleSource& source, const SampledStream& stream) {
  ErrorMeter meter(source, stream);
  const int instants = stream.step_count + 1;
  std::vector<double> of_steps(static_cast<std::size_t>(instants), 0.0);
  double largest = 0.0, fastest = 0.0;
  for (int step = 0; step < instants; ++step) {
    if (step == stream.step_count || stream.steps()[step].passed() == 0) {
      fastest = std::max(fastest, meter.motion_to(meter.time_of(step)));
    }
    double& of_step = of_steps[static_cast<std::size_t>(step)];
    for (const double probe : probes) of_step = std::max(of_step, meter.within(step, probe));
    largest = std::max(largest, of_step);
    if (largest > hopeless_error * source.error_bound) return largest;
  }
  double error = largest;
  for (int step = 0; step < instants; ++step) {
    if (of_steps[static_cast<std::size_t>(step)] < near_largest * largest) continue;
    for (int i = 1; i < close_probes; ++i) error = std::max(error, meter.within(step, i / double{close_probes}));
  }
  const Ticks instant = Ticks{std::int64_t{1} << source.exact.time_shift};
  for (const Ticks jump : source.steps) error = std::max({error, meter.at(jump - instant), meter.at(jump)});
  return error + fraction_rounding * fastest;
}

}  // namespace throng::anim
