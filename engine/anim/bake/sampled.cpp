#include "engine/anim/bake/sampled.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "engine/anim/asset/encode_rows.h"
#include "engine/anim/bake/root_motion.h"
#include "engine/anim/bake/sampled_error.h"
#include "engine/anim/bake/thin_rows.h"

namespace throng::anim {

namespace {

/// The most floats of a stream: half an hour of a character at 30 Hz. More would cost more memory than they are worth.
constexpr std::int64_t most_floats = 1 << 25;
static_assert(most_floats / (rigid_components * packet_bones) < SampledStep::most_rows);

/// Positions nearer to each other than this part of the error bound count as one: 2 micrometres of a person.
constexpr double rounding_of_bound = 0.01;

std::int64_t floats_in_pose(const KeyframeStream& stream) {
  const std::size_t floats = pose_bytes(stream.bone_count, stream.components) / sizeof(float);
  return static_cast<std::int64_t>(floats);
}

SampledRows lay_out_rows(const SampleSource& source, const KeyGrid& grid, Ticks row_step, Ticks last_key) {
  SampledRows rows;
  rows.bone_count = source.exact.bone_count;
  rows.components = source.exact.components;
  rows.step = row_step;
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
    if (source.skeleton.parent(bone) >= 0) continue;
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
  Ticks time = rows.first_row;
  for (int row = 0; row < rows.row_count; ++row) {
    if (row > 0) time += rows.gap_behind(row - 1) * rows.step;
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
  return encode_rows(rows, source.exact.duration);
}

SampledStream& stream_of(const AlignedBytes& block) { return *reinterpret_cast<SampledStream*>(block.get()); }

/// Makes a stream with rotations rounded to the nearest, and with carried rounding if they are too far off.
SampledBake encode(const SampleSource& source, SampledRows& rows) {
  SampledBake bake{.block = sample(source, rows),
                   .rate = static_cast<double>(ticks_per_second.count()) / static_cast<double>(rows.step.count())};
  bake.error =
      turns_too_far(rows) ? std::numeric_limits<double>::infinity() : measure_error(source, stream_of(bake.block));
  if (bake.error <= source.error_bound || bake.error > hopeless_error * source.error_bound) return bake;
  carry_rounding(source.skeleton, rows, stream_of(bake.block));
  bake.rounding = Rounding::carried;
  bake.error = measure_error(source, stream_of(bake.block));
  return bake;
}

/// Parts of the error bound that thinning may use, tried in this order: instants that it skips may err a little more.
constexpr double shares_of_bound[] = {0.98, 0.9, 0.75};

/// Leaves out rows, if the stream stays within its bound.
SampledBake thinned(const SampleSource& source, const SampledRows& all, SampledBake&& even) {
  if (all.row_count <= 2) return std::move(even);
  for (const double share : shares_of_bound) {
    SampledRows rows{.bone_count = all.bone_count,
                     .components = all.components,
                     .first_row = all.first_row,
                     .step = all.step,
                     .gaps = thin_rows(source, all, stream_of(even.block), share * source.error_bound),
                     .rows = {}};
    rows.row_count = static_cast<int>(rows.gaps.size()) + 1;
    if (rows.row_count == all.row_count) break;
    SampledBake bake = encode(source, rows);
    if (bake.error <= source.error_bound) return bake;
  }
  return std::move(even);
}

}  // namespace

SampledBake bake_sampled(const SampleSource& source, const KeyGrid& grid, Ticks last_key) {
  SampledBake best{.block = {}, .error = std::numeric_limits<double>::infinity()};
  for (int multiple = 1; multiple * grid.rate <= finest_sample_rate + 1e-6; ++multiple) {
    const Ticks row_step = to_ticks(1.0 / (grid.rate * multiple));
    SampledRows rows = lay_out_rows(source, grid, row_step, last_key);
    if (rows.row_count > most_floats / floats_in_pose(source.exact)) break;
    SampledBake bake = encode(source, rows);
    if (bake.error <= source.error_bound) return thinned(source, rows, std::move(bake));
    best.error = std::min(best.error, bake.error);
  }
  return best;
}

AlignedBytes sample_as(const SampleSource& source, const SampledStream& stream, Rounding rounding) {
  SampledRows rows = places_of_rows(stream);
  AlignedBytes block = sample(source, rows);
  if (rounding == Rounding::carried) carry_rounding(source.skeleton, rows, stream_of(block));
  return block;
}

SampledBake bake_still(const SampleSource& source) {
  SampledRows rows;
  rows.bone_count = source.exact.bone_count;
  rows.components = source.exact.components;
  rows.step = ticks_per_second;
  rows.row_count = 1;
  return encode(source, rows);
}

}  // namespace throng::anim
