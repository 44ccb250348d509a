#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "engine/anim/import/document.h"

namespace throng::import {

/// The most numbers that are decoded from one file, all accessors together. Views may overlap, so without this limit a
/// small file could ask for any number.
inline constexpr std::size_t max_decoded_values = std::size_t{1} << 27U;

/// The most elements of an accessor without a buffer view, whose numbers are all 0.
inline constexpr std::size_t max_elements_without_view = std::size_t{1} << 20U;

/// Checks element counts, and that every accessor, sparse parts included, lies inside its views. Sparse indices that do
/// not ascend (glTF 2.0, 5.1.3) become a repair. Throws Refusal.
void check_accessors(Document& document);

/// Lists component types, TINYGLTF_COMPONENT_TYPE_...; here the types that several properties accept.
using Components = std::initializer_list<int>;
inline constexpr Components float_alone = {TINYGLTF_COMPONENT_TYPE_FLOAT};
inline constexpr Components any_unsigned = {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
                                            TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                                            TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT};
inline constexpr Components float_or_unsigned = {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
                                                 TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT};
inline constexpr Components float_or_small = {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE,
                                              TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_SHORT,
                                              TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT};

/// The accessors that a property accepts.
struct AccessorRule {
  std::string what;                  ///< for messages: the object and the property
  std::initializer_list<int> types;  ///< TINYGLTF_TYPE_...
  Components components;             ///< integers must be normalised unless `raw`
  bool raw = false;                  ///< integers stand for themselves
};

/// Reads all numbers of the first `limit` elements, [element][component], converted as glTF 2.0, 3.6.2.2 and 3.11 say:
/// normalised integers become [0, 1] or [-1, 1], sparse elements are in place, and numbers without a view are 0.
/// Charges Document::memory. Throws Refusal.
std::vector<float> read_floats(const Document& document, int accessor, const AccessorRule& rule,
                               std::size_t limit = SIZE_MAX);

/// Reads unsigned integers in the same way.
std::vector<std::uint32_t> read_integers(const Document& document, int accessor, const AccessorRule& rule);

/// Returns the bytes of one component, or 0 for a type that glTF does not know.
std::size_t component_size(int component_type);

bool all_finite(std::span<const float> values);

/// Makes vectors or quaternions of flat numbers, which have the same layout.
template <typename Vector>
std::vector<Vector> grouped(std::span<const float> values) {
  static_assert(sizeof(Vector) == static_cast<std::size_t>(Vector::length()) * sizeof(float));
  std::vector<Vector> vectors(values.size() * sizeof(float) / sizeof(Vector));
  if (!vectors.empty()) std::memcpy(vectors.data(), values.data(), vectors.size() * sizeof(Vector));
  return vectors;
}

const tinygltf::Accessor& accessor_at(const Document& document, int accessor);

}  // namespace throng::import
