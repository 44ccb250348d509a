#pragma once

#include <span>
#include <string_view>

namespace throng::import {

/// What a property of a glTF object must be.
enum class Kind : unsigned char {
  flag,
  integer,  ///< >= 0
  number,   ///< finite
  numbers,  ///< array of `count` finite numbers; any number of them where count is 0
  text,
  choice,  ///< one of the texts that `target` lists, divided by "|"
  texts,
  index,    ///< into the document's top-level array `target`
  indices,  ///< array of those, at least `count`, no two equal
  object,   ///< of the type `target`
  objects,  ///< array of those, at least `count`
};

/// One property of one type of object (glTF 2.0, chapter 5). The key "*" stands for every key of the object.
struct Property {
  std::string_view owner;
  std::string_view key;
  Kind kind = Kind::text;
  std::string_view target = {};
  int count = 0;
  bool required = false;
};

/// The properties that import reads, grouped by owner; what is not listed is ignored.
std::span<const Property> gltf_schema();

}  // namespace throng::import
