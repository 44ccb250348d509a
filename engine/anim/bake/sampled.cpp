#include "engine/anim/bake/sampled.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include "engine/anim/bake/root_motion.h"
#include "engine/anim/kernel/kernels.h"

namespace throng::anim {

namespace {

/// The most floats of a stream: half an hour of a character at 30 Hz. More would cost more memory than they are worth.
constexpr Ticks most_floats = 1 << 25;

/// A higher rate must bring the error below this share. The rest may be quantisation, which no rate mends.
constexpr double worthwhile = 0.9;

/// Positions nearer to each other than this part of the error bound count as one: 2 micrometres of a person.
constexpr double rounding_of_bound = 0.01;

/// Errors are measured at these fractions of the way between two rows: on a row, midway (CUBICSPLINE), and where a
/// chord strays most from its arc.
constexpr double probes[] = {0.0, 0.21, 0.5, 0.79};

Ticks floats_in_pose(const KeyframeStream& stream) {
  const std::size_t floats = pose_bytes(stream.bone_count, stream.components) / sizeof(float);
  return static_cast<Ticks>(floats);
}

SampledRows lay_out_rows(const SampleSource& source, const KeyGrid& grid, Ticks row_step, Ticks last_key) {
  SampledRows rows;
  rows.bone_count = source.exact.bone_count;
  rows.components = source.exact.components;
  rows.row_step = row_step;
  rows.first_row = grid.first;
  const bool drifts = source.travel != glm::dvec3(0.0);
  if (drifts && grid.first > 0) rows.first_row -= (grid.first + row_step - 1) / row_step * row_step;
  const Ticks end = drifts ? source.exact.duration : last_key;
  // A last step that is only the rounding of times does not count.
  const Ticks steps = (end - rows.first_row + row_step - row_step / 64) / row_step;
  rows.row_count = static_cast<int>(std::min<Ticks>(steps, INT32_MAX - 1)) + 1;
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
    const Ticks within = std::clamp<Ticks>(time, 0, source.exact.duration);
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

SampledBake encode(const SampleSource& source, SampledRows& rows) {
  SampledBake bake{.block = sample(source, rows),
                   .rate = static_cast<double>(ticks_per_second) / static_cast<double>(rows.row_step)};
  bake.error = turns_too_far(rows) ? std::numeric_limits<double>::infinity()
                                   : measure_error(source, *reinterpret_cast<const SampledStream*>(bake.block.get()));
  return bake;
}

void sample_pose(const SampledStream& stream, Ticks time, std::span<float> pose) {
  const Kernels& kernels = best_kernels();
  for (int packet = 0; packet < stream.packet_count(); ++packet) {
    float* out = pose.data() + static_cast<std::ptrdiff_t>(packet) * stream.components * packet_bones;
    kernels.sample({.stream = &stream, .point = locate(stream, time), .packet = packet, .pose = out});
  }
}

}  // namespace

double measure_error(const SampleSource& source, const SampledStream& stream) {
  ExactPoses exact(source.exact);
  const std::size_t size = pose_bytes(stream.bone_count, stream.components);
  const AlignedBytes bytes = allocate_aligned(size);
  const std::span pose(reinterpret_cast<float*>(bytes.get()), size / sizeof(float));
  std::vector<BoneFrame> expected(source.skeleton.bones.size());
  std::vector<BoneFrame> sampled(source.skeleton.bones.size());
  double error = 0.0;
  for (int row = 0; row < stream.row_count; ++row) {
    for (const double probe : probes) {
      const auto between = static_cast<Ticks>(probe * static_cast<double>(stream.row_step));
      const Ticks time = std::clamp<Ticks>(stream.first_row + row * stream.row_step + between, 0, stream.duration);
      compute_frames(source.skeleton, exact.at(time), expected);
      sample_pose(stream, time, pose);
      compute_frames(source.skeleton, pose, sampled);
      error = std::max(error, largest_distance(source.proxy, expected, sampled));
    }
  }
  return error;
}

SampledBake bake_sampled(const SampleSource& source, const KeyGrid& grid, Ticks last_key) {
  SampledBake best;
  for (int multiple = 1; multiple * grid.rate <= highest_sample_rate + 1e-6; ++multiple) {
    const Ticks row_step = to_ticks(1.0 / (grid.rate * multiple));
    SampledRows rows = lay_out_rows(source, grid, row_step, last_key);
    if (rows.row_count > most_floats / floats_in_pose(source.exact)) break;
    SampledBake bake = encode(source, rows);
    const bool keeps_to_bound = bake.error <= source.error_bound;
    if (keeps_to_bound || !best.block || bake.error < worthwhile * best.error) best = std::move(bake);
    if (keeps_to_bound) break;
  }
  return best;
}

AlignedBytes sample_as(const SampleSource& source, const SampledStream& stream) {
  SampledRows rows{.bone_count = stream.bone_count,
                   .components = stream.components,
                   .first_row = stream.first_row,
                   .row_step = stream.row_step,
                   .row_count = stream.row_count,
                   .rows = {}};
  return sample(source, rows);
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
