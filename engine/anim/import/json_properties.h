#pragma once

#include <span>
#include <string_view>

namespace throng::import {

/// The kinds of property that a glTF object has.
enum class Kind : unsigned char {
  flag,
  integer,  ///< >= 0
  number,   ///< finite, as a float too
  numbers,  ///< array of `count` finite numbers; of any length where count is 0
  text,
  choice,  ///< one of the texts that `target` lists, divided by "|"
  texts,
  index,    ///< into the document's top-level array `target`
  indices,  ///< array of indices, at least `count`, no two equal
  object,   ///< of the type `target`
  objects,  ///< array of objects, at least `count`
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

/// Returns the properties that import reads, grouped by owner. All others are ignored.
std::span<const Property> read_properties();

}  // namespace throng::import
