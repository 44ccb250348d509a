#include "engine/anim/asset/morph_curves.h"

#include <algorithm>
#include <cstddef>

namespace throng::anim {

namespace {

/// Returns the places, among the track's morphs, of the morphs that any row moves away from 0.
std::vector<std::size_t> moving_columns(const MorphTrack& track) {
  const std::size_t columns = track.morphs.size();
  std::vector<std::size_t> moving;
  for (std::size_t column = 0; column < columns; ++column) {
    for (std::size_t i = column; i < track.weights.size(); i += columns) {
      if (track.weights[i] == 0.0F) continue;
      moving.push_back(column);
      break;
    }
  }
  return moving;
}

/// Keeps the first key alone where all keys are the same, with tangents of 0.
void drop_still_keys(MorphCurve& curve) {
  const std::size_t columns = curve.morphs.size();
  const bool cubic = curve.interpolation == Interpolation::cubic_spline;
  const std::size_t rows = values_a_key(curve.interpolation);
  const auto weight = [&](std::size_t key, std::size_t row, std::size_t column) {
    return curve.weights[(key * rows + row) * columns + column];
  };
  for (std::size_t key = 0; key < curve.times.size(); ++key) {
    for (std::size_t column = 0; column < columns; ++column) {
      if (weight(key, cubic ? 1 : 0, column) != weight(0, cubic ? 1 : 0, column)) return;
      if (cubic && (weight(key, 0, column) != 0.0F || weight(key, 2, column) != 0.0F)) return;
    }
  }
  curve.times.resize(1);
  curve.weights.resize(rows * columns);
}

MorphCurve curve_of(const MorphTrack& track, double start) {
  MorphCurve curve{.interpolation = track.interpolation, .morphs = {}, .times = {}, .weights = {}};
  const std::vector<std::size_t> columns = moving_columns(track);
  if (columns.empty()) return curve;
  for (const std::size_t column : columns) curve.morphs.push_back(static_cast<std::uint32_t>(track.morphs[column]));
  for (const float time : track.times) curve.times.push_back(to_ticks(static_cast<double>(time) - start));
  for (std::size_t row = 0; row < track.weights.size(); row += track.morphs.size()) {
    for (const std::size_t column : columns) curve.weights.push_back(track.weights[row + column]);
  }
  drop_still_keys(curve);
  return curve;
}

/// How much the four rows of weights around a time count (glTF 2.0, appendix C).
struct RowShares {
  std::size_t from = 0, to = 0;                  // rows of weights
  float from_share = 1.0F, to_share = 0.0F;      // of these
  std::size_t from_tangent = 0, to_tangent = 0;  // rows of tangents
  float from_slope = 0.0F, to_slope = 0.0F;      // of these
};

RowShares shares_at(const MorphCurve& curve, Ticks time) {
  const auto after = std::ranges::upper_bound(curve.times, time);
  const auto next = static_cast<std::size_t>(after - curve.times.begin());
  const std::size_t key = next == 0 ? 0 : next - 1;
  const bool cubic = curve.interpolation == Interpolation::cubic_spline;
  const std::size_t rows = values_a_key(curve.interpolation), middle = cubic ? 1 : 0;
  RowShares shares{.from = key * rows + middle, .to = key * rows + middle};
  if (next == 0 || next == curve.times.size() || curve.interpolation == Interpolation::step) return shares;
  shares.to = next * rows + middle;
  const Ticks length = curve.times[next] - curve.times[key];
  const auto u =
      static_cast<float>(static_cast<double>((time - curve.times[key]).count()) / static_cast<double>(length.count()));
  shares.to_share = cubic ? u * u * (3.0F - 2.0F * u) : u;
  shares.from_share = 1.0F - shares.to_share;
  if (!cubic) return shares;
  const auto seconds = static_cast<float>(to_seconds(length));
  shares.from_tangent = shares.from + 1;
  shares.to_tangent = shares.to - 1;
  shares.from_slope = seconds * u * (u - 1.0F) * (u - 1.0F);
  shares.to_slope = seconds * u * u * (u - 1.0F);
  return shares;
}

}  // namespace

MorphCurves bake_morph_curves(const Clip& clip, double start) {
  MorphCurves curves;
  for (const MorphTrack& track : clip.morph_tracks) {
    MorphCurve curve = curve_of(track, start);
    if (!curve.morphs.empty()) curves.push_back(std::move(curve));
  }
  return curves;
}

void add_morph_weights(const MorphCurves& curves, Ticks time, float share, std::span<float> weights,
                       std::uint32_t first) {
  for (const MorphCurve& curve : curves) {
    const RowShares shares = shares_at(curve, time);
    const std::size_t columns = curve.morphs.size();
    const auto row = [&](std::size_t index) { return curve.weights.data() + index * columns; };
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t place = std::size_t{curve.morphs[i]} - first;  // huge for morphs before the first
      if (place >= weights.size()) continue;
      float weight = shares.from_share * row(shares.from)[i] + shares.to_share * row(shares.to)[i];
      weight += shares.from_slope * row(shares.from_tangent)[i] + shares.to_slope * row(shares.to_tangent)[i];
      weights[place] += share * weight;
    }
  }
}

}  // namespace throng::anim
