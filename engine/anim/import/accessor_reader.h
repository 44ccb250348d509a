#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "engine/anim/import/document.h"

namespace throng::import {

/// Most numbers that are decoded from one file, all accessors together; views may overlap, so that a small file could
/// ask for any number.
inline constexpr std::size_t max_decoded_values = std::size_t{1} << 27U;

/// Most elements that are made up for an accessor without buffer view, which stands for zeros.
inline constexpr std::size_t max_elements_without_view = std::size_t{1} << 20U;

/// Which accessors a property takes.
struct AccessorRule {
  std::string what;                       ///< for messages: whose and which
  std::initializer_list<int> types;       ///< TINYGLTF_TYPE_...
  std::initializer_list<int> components;  ///< TINYGLTF_COMPONENT_TYPE_...; integers must be normalised unless `raw`
  bool raw = false;                       ///< integers may stand for themselves
};

/// All numbers of the first `limit` elements, [element][component], converted as glTF 2.0, 3.6.2.2 and 3.11 say:
/// normalised integers become [0, 1] or [-1, 1], sparse elements are in place, no view means zeros. Throws Refusal.
std::vector<float> read_floats(const Document& document, int accessor, const AccessorRule& rule,
                               std::size_t limit = SIZE_MAX);

/// The same for unsigned integers.
std::vector<std::uint32_t> read_integers(const Document& document, int accessor, const AccessorRule& rule);

const tinygltf::Accessor& accessor_at(const Document& document, int accessor);

}  // namespace throng::import
