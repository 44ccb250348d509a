#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "engine/anim/import/document.h"

namespace throng::import {

/// The most numbers that are decoded from one file, all accessors together. Views may overlap, so without this limit a
/// small file could ask for any number.
inline constexpr std::size_t max_decoded_values = std::size_t{1} << 27U;

/// The most elements of an accessor without a buffer view, whose numbers are all 0.
inline constexpr std::size_t max_elements_without_view = std::size_t{1} << 20U;

/// The accessors that a property accepts.
struct AccessorRule {
  std::string what;                       ///< for messages: the object and the property
  std::initializer_list<int> types;       ///< TINYGLTF_TYPE_...
  std::initializer_list<int> components;  ///< TINYGLTF_COMPONENT_TYPE_...; integers must be normalised unless `raw`
  bool raw = false;                       ///< integers stand for themselves
};

/// Reads all numbers of the first `limit` elements, [element][component], converted as glTF 2.0, 3.6.2.2 and 3.11 say:
/// normalised integers become [0, 1] or [-1, 1], sparse elements are in place, and numbers without a view are 0. Throws
/// Refusal.
std::vector<float> read_floats(const Document& document, int accessor, const AccessorRule& rule,
                               std::size_t limit = SIZE_MAX);

/// Does the same for unsigned integers.
std::vector<std::uint32_t> read_integers(const Document& document, int accessor, const AccessorRule& rule);

const tinygltf::Accessor& accessor_at(const Document& document, int accessor);

}  // namespace throng::import
