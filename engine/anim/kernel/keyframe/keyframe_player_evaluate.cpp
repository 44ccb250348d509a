#include <cassert>
#include <cmath>

#include "engine/anim/kernel/keyframe/keyframe_player.h"

namespace throng::anim {

namespace {

using Lanes = float[packet_bones];

/// How far each lane is from its `from` key to its `to` key, 0 to 1.
void segment_fractions(const SegmentTiming& timing, std::int32_t now, Lanes& fractions) {
  for (int i = 0; i < packet_bones; ++i) {
    const float fraction = static_cast<float>(now - timing.start[i]) * timing.reciprocal_span[i];
    const float begun = fraction < 0.0F ? 0.0F : fraction;
    fractions[i] = begun > 1.0F ? 1.0F : begun;
  }
}

/// sin(sqrt(y)) / sqrt(y) for y up to (pi/2)^2, to 1e-8: the Taylor series.
inline float sine_ratio(float y) {
  float sum = 1.0F / 6227020800.0F;
  sum = sum * y - 1.0F / 39916800.0F;
  sum = sum * y + 1.0F / 362880.0F;
  sum = sum * y - 1.0F / 5040.0F;
  sum = sum * y + 1.0F / 120.0F;
  sum = sum * y - 1.0F / 6.0F;
  return sum * y + 1.0F;
}

/// The square of the angle whose cosine is 1 - e, for e from 0 to 1, to 2e-8: a Chebyshev fit of acos(1 - e)^2 / e. The
/// square has no root in it, so near keys lose nothing.
inline float squared_angle(float e) {
  float sum = 0.00169988424F;
  sum = sum * e - 0.00473859411F;
  sum = sum * e + 0.00779832717F;
  sum = sum * e - 0.00426012978F;
  sum = sum * e + 0.00662470988F;
  sum = sum * e + 0.00936489201F;
  sum = sum * e + 0.0286999176F;
  sum = sum * e + 0.0888784321F;
  sum = sum * e + 0.333333661F;
  return (sum * e + 2.0F) * e;
}

/// Spherical interpolation (glTF 2.0, C.4) of unit keys on one hemisphere; a vanishing angle needs no case of its own.
void slerp(const RigidInterpolation& keys, const Lanes& fractions, float* rotation) {
  for (int i = 0; i < packet_bones; ++i) {
    float chord = 0.0F;
    for (int c = 0; c < 4; ++c) {
      const float difference = keys.rotation_to[c][i] - keys.rotation_from[c][i];
      chord += difference * difference;
    }
    const float y = squared_angle(0.5F * chord);
    const float u = fractions[i];
    const float v = 1.0F - u;
    const float scale = 1.0F / sine_ratio(y);
    const float from_weight = v * sine_ratio(v * v * y) * scale;
    const float to_weight = u * sine_ratio(u * u * y) * scale;
    float q[4];
    float norm = 0.0F;
    for (int c = 0; c < 4; ++c) {
      q[c] = from_weight * keys.rotation_from[c][i] + to_weight * keys.rotation_to[c][i];
      norm += q[c] * q[c];
    }
    // One Newton step from 1 for the inverse square root: the norm is nearly 1.
    const float unit = 1.5F - 0.5F * norm;
    for (int c = 0; c < 4; ++c) rotation[c * packet_bones + i] = q[c] * unit;
  }
}

void lerp(const Lanes* from, const Lanes* to, const Lanes& fractions, float* out) {
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < packet_bones; ++i) {
      out[c * packet_bones + i] = (1.0F - fractions[i]) * from[c][i] + fractions[i] * to[c][i];
    }
  }
}

/// glTF 2.0, C.5, component by component; the tangents are read from the stream, behind the arriving key's value.
void hermite_lane(const float* tangents, int width, const Lanes* from, const Lanes* to, int lane, float u, float* out) {
  const float u2 = u * u;
  const float u3 = u2 * u;
  for (int c = 0; c < width; ++c) {
    out[c * packet_bones + lane] = (2.0F * u3 - 3.0F * u2 + 1.0F) * from[c][lane] + (u3 - 2.0F * u2 + u) * tangents[c] +
                                   (3.0F * u2 - 2.0F * u3) * to[c][lane] + (u3 - u2) * tangents[width + c];
  }
}

void normalise_lane(float* rotation, int lane) {
  float norm = 0.0F;
  for (int c = 0; c < 4; ++c) norm += rotation[c * packet_bones + lane] * rotation[c * packet_bones + lane];
  if (norm < 1e-20F) {
    for (int c = 0; c < 4; ++c) rotation[c * packet_bones + lane] = c == 3 ? 1.0F : 0.0F;
    return;
  }
  const float unit = 1.0F / std::sqrt(norm);
  for (int c = 0; c < 4; ++c) rotation[c * packet_bones + lane] *= unit;
}

/// Where each part of a channel of one packet is.
struct ChannelKeys {
  KeyChannel channel;
  const Lanes* from;
  const Lanes* to;
  const SegmentTiming& timing;
};

/// Does the lanes with CUBICSPLINE tracks again, as they must be.
void evaluate_cubic_lanes(const KeyframeStream& stream, int packet, const ChannelKeys& keys, const Lanes& fractions,
                          float* out) {
  const unsigned lanes = stream.cubic_lanes(packet, keys.channel);
  if (lanes == 0) return;
  const int width = key_width(keys.channel);
  for (int i = 0; i < packet_bones; ++i) {
    if ((lanes >> i & 1U) == 0) continue;
    const float* tangents = stream.values(keys.channel) + keys.timing.arriving_key[i] + width;
    hermite_lane(tangents, width, keys.from, keys.to, i, fractions[i], out);
    if (keys.channel == KeyChannel::rotation) normalise_lane(out, i);
  }
}

void evaluate_vectors(const KeyframeStream& stream, int packet, std::int32_t now, const ChannelKeys& keys, float* out) {
  Lanes fractions;
  segment_fractions(keys.timing, now, fractions);
  lerp(keys.from, keys.to, fractions, out);
  evaluate_cubic_lanes(stream, packet, keys, fractions, out);
}

}  // namespace

void evaluate_keyframes(const KeyframeStream& stream, Ticks time, std::span<const std::byte> interpolations, int packet,
                        std::span<float> pose) {
  assert(packet >= 0 && packet < packets_for(stream.bone_count));
  assert(pose.size() >= static_cast<std::size_t>(stream.components) * packet_bones);
  const std::int32_t now = stream.time_units(time);
  const std::byte* bytes =
      interpolations.data() + static_cast<std::size_t>(packet) * interpolation_packet_bytes(stream.components);
  const auto& keys = *reinterpret_cast<const RigidInterpolation*>(bytes);

  Lanes fractions;
  segment_fractions(keys.rotation, now, fractions);
  slerp(keys, fractions, pose.data());
  evaluate_cubic_lanes(stream, packet, {KeyChannel::rotation, keys.rotation_from, keys.rotation_to, keys.rotation},
                       fractions, pose.data());
  evaluate_vectors(stream, packet, now, {KeyChannel::position, keys.position_from, keys.position_to, keys.position},
                   pose.data() + 4 * packet_bones);
  if (stream.components != general_components) return;
  const auto& scale = *reinterpret_cast<const ScaleInterpolation*>(bytes + sizeof(RigidInterpolation));
  evaluate_vectors(stream, packet, now, {KeyChannel::scale, scale.scale_from, scale.scale_to, scale.scale},
                   pose.data() + rigid_components * packet_bones);
}

}  // namespace throng::anim
