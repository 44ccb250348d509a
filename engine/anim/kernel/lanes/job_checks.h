#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "engine/anim/base/pose.h"

/// Checks that the is_valid functions of all jobs share. They allocate nothing and write nothing.
namespace throng::anim {

inline constexpr std::size_t job_alignment = 64;  ///< bytes, for every pointer whose job states no other

inline bool is_aligned(const void* memory, std::size_t alignment = job_alignment) {
  return memory != nullptr && reinterpret_cast<std::uintptr_t>(memory) % alignment == 0;
}
inline bool is_null_or_aligned(const void* memory) { return memory == nullptr || is_aligned(memory); }

/// Returns whether two arrays of floats have no byte in common. A null pointer has none.
inline bool are_apart(const float* a, std::size_t a_floats, const float* b, std::size_t b_floats) {
  const std::less_equal<> not_above;
  return a == nullptr || b == nullptr || not_above(a + a_floats, b) || not_above(b + b_floats, a);
}

/// Both functions return false for NaN.
inline bool is_share(float share) { return share >= 0.0F && share <= 1.0F; }
inline bool is_not_negative(float value) { return value >= 0.0F && std::isfinite(value); }

/// Returns whether `weights` is null or has 16 weights from 0 to 1.
inline bool are_bone_weights(const float* weights) {
  if (!is_null_or_aligned(weights)) return false;
  for (int bone = 0; weights != nullptr && bone < packet_bones; ++bone) {
    if (!is_share(weights[bone])) return false;
  }
  return true;
}

inline bool is_component_count(int components) {
  return components == rigid_components || components == general_components;
}

}  // namespace throng::anim
