#pragma once

#include "engine/anim/import/document.h"

namespace throng::import {

/// Checks component types and element counts, and that every accessor, sparse parts included, lies inside its views.
/// Throws Refusal.
void check_accessors(const Document& document);

/// Returns the bytes of one component, or 0 for a type that glTF does not know.
std::size_t component_size(int component_type);

/// Returns the numbers in one element: 1 to 16.
std::size_t element_width(const tinygltf::Accessor& accessor);

/// Returns the byte offset of a number in its element. Columns of small matrices start on 4-byte boundaries (glTF 2.0,
/// 3.6.2.4).
std::size_t component_offset(const tinygltf::Accessor& accessor, std::size_t component);

/// Returns the bytes of one element, without padding after it.
std::size_t element_size(const tinygltf::Accessor& accessor);

}  // namespace throng::import
