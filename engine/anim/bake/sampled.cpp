#include "engine/anim/bake/sampled.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "engine/anim/bake/root_motion.h"
#include "engine/anim/kernel/kernels.h"

namespace throng::anim {

namespace {

/// The most floats of a stream: half an hour of a character at 30 Hz. More would cost more memory than they are worth.
constexpr std::int64_t most_floats = 1 << 25;

/// Times the bound: rounding alone errs less, so other rounding cannot mend more.
constexpr double hopeless = 4.0;

/// Positions nearer to each other than this part of the error bound count as one: 2 micrometres of a person.
constexpr double rounding_of_bound = 0.01;

/// Errors are measured at these fractions of the way between two rows: on a row, midway (CUBICSPLINE), and where a
/// chord strays most from its arc.
constexpr double probes[] = {0.0, 0.21, 0.5, 0.79};

/// Between rows whose error comes this near to the largest, they are measured again at so many times.
constexpr double near_largest = 0.9;
constexpr int close_probes = 16;

/// The kernels round fractions between two rows, so that a pose may be early or late by so much of the way.
constexpr double fraction_rounding = 0.5 / sample_fraction_one;

std::int64_t floats_in_pose(const KeyframeStream& stream) {
  const std::size_t floats = pose_bytes(stream.bone_count, stream.components) / sizeof(float);
  return static_cast<std::int64_t>(floats);
}

SampledRows lay_out_rows(const SampleSource& source, const KeyGrid& grid, Ticks row_step, Ticks last_key) {
  SampledRows rows;
  rows.bone_count = source.exact.bone_count;
  rows.components = source.exact.components;
  rows.row_step = row_step;
  rows.first_row = grid.first;
  const bool drifts = source.travel != glm::dvec3(0.0);
  if (drifts && grid.first > Ticks{}) rows.first_row -= (grid.first + row_step - Ticks{1}) / row_step * row_step;
  const Ticks end = drifts ? source.exact.duration : last_key;
  // A last step that is only the rounding of times does not count.
  const std::int64_t steps = (end - rows.first_row + row_step - row_step / 64) / row_step;
  rows.row_count = static_cast<int>(std::min<std::int64_t>(steps, INT32_MAX - 1)) + 1;
  return rows;
}

/// Continues the straight line of the root motion before and after the clip.
void extend_drift(const SampleSource& source, double seconds_outside, std::span<float> pose) {
  const glm::dvec3 per_second = source.travel / to_seconds(source.exact.duration);
  for (int bone = 0; bone < source.skeleton.bone_count(); ++bone) {
    if (source.skeleton.bones[static_cast<std::size_t>(bone)].parent >= 0) continue;
    const glm::dvec3 drift = drift_of_root(source.skeleton, bone, per_second * seconds_outside);
    const int first = (bone / packet_bones * source.exact.components + 4) * packet_bones + bone % packet_bones;
    float* const position = &pose[static_cast<std::size_t>(first)];
    for (int axis = 0; axis < 3; ++axis) {
      position[axis * packet_bones] -= static_cast<float>(drift[axis]);
    }
  }
}

void fill_rows(const SampleSource& source, SampledRows& rows) {
  ExactPoses exact(source.exact);
  for (int row = 0; row < rows.row_count; ++row) {
    const Ticks time = rows.first_row + row * rows.row_step;
    const Ticks within = std::clamp(time, Ticks{}, source.exact.duration);
    const std::span<float> pose = exact.at(within);
    const std::size_t start = rows.rows.size();
    rows.rows.insert(rows.rows.end(), pose.begin(), pose.end());
    if (time != within) extend_drift(source, to_seconds(time - within), std::span(rows.rows).subspan(start));
  }
}

/// Makes a component of a position stand still in all rows if it moves by no more than rounding of 32-bit keys and bind
/// poses; at the bind pose, if it is there. Exporters leave a micrometre on many bones, which kernels would otherwise
/// sample and add.
void drop_rounding(SampledRows& rows, std::size_t component, std::size_t pose_floats, float negligible) {
  float lowest = rows.rows[component], highest = lowest;
  for (std::size_t at = component; at < rows.rows.size(); at += pose_floats) {
    lowest = std::min(lowest, rows.rows[at]);
    highest = std::max(highest, rows.rows[at]);
  }
  if (highest - lowest > negligible) return;
  const bool is_at_rest = std::max(-lowest, highest) <= negligible;
  const float still = is_at_rest ? 0.0F : 0.5F * lowest + 0.5F * highest;
  for (std::size_t at = component; at < rows.rows.size(); at += pose_floats) rows.rows[at] = still;
}

void drop_rounding_of_positions(SampledRows& rows, float negligible) {
  const std::size_t packet_floats = static_cast<std::size_t>(rows.components) * packet_bones;
  const std::size_t pose_floats = packet_floats * static_cast<std::size_t>(packets_for(rows.bone_count));
  for (std::size_t packet = 0; packet < pose_floats; packet += packet_floats) {
    for (std::size_t lane = 4 * packet_bones; lane < 7 * packet_bones; ++lane) {
      drop_rounding(rows, packet + lane, pose_floats, negligible);
    }
  }
}

AlignedBytes sample(const SampleSource& source, SampledRows& rows) {
  fill_rows(source, rows);
  drop_rounding_of_positions(rows, static_cast<float>(rounding_of_bound * source.error_bound));
  const std::size_t size = sampled_stream_bytes(rows);
  AlignedBytes block = allocate_aligned(size);
  encode_sampled_stream(rows, source.exact.duration, {block.get(), size});
  return block;
}

SampledStream& stream_of(const AlignedBytes& block) { return *reinterpret_cast<SampledStream*>(block.get()); }

/// Makes a stream with rotations rounded to the nearest, and with carried rounding if they are too far off.
SampledBake encode(const SampleSource& source, SampledRows& rows) {
  SampledBake bake{.block = sample(source, rows),
                   .rate = static_cast<double>(ticks_per_second.count()) / static_cast<double>(rows.row_step.count())};
  bake.error =
      turns_too_far(rows) ? std::numeric_limits<double>::infinity() : measure_error(source, stream_of(bake.block));
  if (bake.error <= source.error_bound || bake.error > hopeless * source.error_bound) return bake;
  carry_rounding(source.skeleton, rows, stream_of(bake.block));
  bake.rounding = Rounding::carried;
  bake.error = measure_error(source, stream_of(bake.block));
  return bake;
}

/// Compares a sampled stream with the exact one on the surface.
class ErrorMeter {
 public:
  ErrorMeter(const SampleSource& source, const SampledStream& stream)
      : source_(source),
        stream_(stream),
        exact_(source.exact),
        bytes_(allocate_aligned(pose_bytes(stream.bone_count, stream.components))),
        expected_(source.skeleton.bones.size()),
        sampled_(source.skeleton.bones.size()) {}

  double at(Ticks time) {
    const Ticks within = std::clamp(time, Ticks{}, stream_.duration);
    compute_frames(source_.skeleton, exact_.at(within), expected_);
    compute_frames(source_.skeleton, sampled_pose(within), sampled_);
    return largest_distance(source_.proxy, expected_, sampled_);
  }

  /// Returns the distance that the exact surface moves from the time of the last call of this function.
  double motion_to(Ticks time) {
    compute_frames(source_.skeleton, exact_.at(std::clamp(time, Ticks{}, stream_.duration)), expected_);
    const double motion = last_.empty() ? 0.0 : largest_distance(source_.proxy, last_, expected_);
    last_ = expected_;
    return motion;
  }

  /// Measures at a part of the way from one row to the next.
  double behind(int row, double part) {
    const Ticks between{static_cast<std::int64_t>(part * static_cast<double>(stream_.row_step.count()))};
    return at(stream_.first_row + row * stream_.row_step + between);
  }

 private:
  std::span<const float> sampled_pose(Ticks time) {
    const Kernels& kernels = best_kernels();
    auto* const pose = reinterpret_cast<float*>(bytes_.get());
    for (int packet = 0; packet < stream_.packet_count(); ++packet) {
      float* const out = pose + static_cast<std::ptrdiff_t>(packet) * stream_.components * packet_bones;
      kernels.sample({.stream = &stream_, .point = locate(stream_, time), .packet = packet, .pose = out});
    }
    return {pose, pose_bytes(stream_.bone_count, stream_.components) / sizeof(float)};
  }

  const SampleSource& source_;
  const SampledStream& stream_;
  ExactPoses exact_;
  AlignedBytes bytes_;
  std::vector<BoneFrame> expected_, sampled_, last_;
};

}  // namespace

double measure_error(const SampleSource& source, const SampledStream& stream) {
  ErrorMeter meter(source, stream);
  std::vector<double> of_rows(static_cast<std::size_t>(stream.row_count), 0.0);
  double largest = 0.0, fastest = 0.0;
  for (int row = 0; row < stream.row_count; ++row) {
    fastest = std::max(fastest, meter.motion_to(stream.first_row + row * stream.row_step));
    double& of_row = of_rows[static_cast<std::size_t>(row)];
    for (const double probe : probes) of_row = std::max(of_row, meter.behind(row, probe));
    largest = std::max(largest, of_row);
    if (largest > hopeless * source.error_bound) return largest;
  }
  double error = largest;
  for (int row = 0; row < stream.row_count; ++row) {
    if (of_rows[static_cast<std::size_t>(row)] < near_largest * largest) continue;
    for (int i = 1; i < close_probes; ++i) error = std::max(error, meter.behind(row, i / double{close_probes}));
  }
  const Ticks instant = Ticks{std::int64_t{1} << source.exact.time_shift};
  for (const Ticks step : source.steps) error = std::max({error, meter.at(step - instant), meter.at(step)});
  return error + fraction_rounding * fastest;
}

SampledBake bake_sampled(const SampleSource& source, const KeyGrid& grid, Ticks last_key) {
  SampledBake best{.block = {}, .error = std::numeric_limits<double>::infinity()};
  for (int multiple = 1; multiple * grid.rate <= finest_sample_rate + 1e-6; ++multiple) {
    const Ticks row_step = to_ticks(1.0 / (grid.rate * multiple));
    SampledRows rows = lay_out_rows(source, grid, row_step, last_key);
    if (rows.row_count > most_floats / floats_in_pose(source.exact)) break;
    SampledBake bake = encode(source, rows);
    if (bake.error <= source.error_bound) return bake;
    best.error = std::min(best.error, bake.error);
  }
  return best;
}

AlignedBytes sample_as(const SampleSource& source, const SampledStream& stream, Rounding rounding) {
  SampledRows rows{.bone_count = stream.bone_count,
                   .components = stream.components,
                   .first_row = stream.first_row,
                   .row_step = stream.row_step,
                   .row_count = stream.row_count,
                   .rows = {}};
  AlignedBytes block = sample(source, rows);
  if (rounding == Rounding::carried) carry_rounding(source.skeleton, rows, stream_of(block));
  return block;
}

SampledBake bake_still(const SampleSource& source) {
  SampledRows rows;
  rows.bone_count = source.exact.bone_count;
  rows.components = source.exact.components;
  rows.row_step = ticks_per_second;
  rows.row_count = 1;
  return encode(source, rows);
}

}  // namespace throng::anim
