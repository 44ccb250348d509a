#pragma once

#include <string>

#include <gtest/gtest.h>

#include "throng/character_builder.h"

namespace throng::api_test {

/// Returns the character that a builder builds.
inline Character built(const CharacterBuilder& builder, const LoadOptions& options = {}) {
  const auto file = builder.build(options);
  EXPECT_TRUE(file) << (file ? "" : file.error().message);
  return file ? file->characters.front() : Character();
}

/// Tells a builder of a bone and a tip, 1 m above it, with a clip of a second.
inline CharacterBuilder small() {
  CharacterBuilder builder("small");
  builder.add_bone({.name = "root"});
  builder.add_bone({.name = "tip", .parent = 0, .rest = {.translation = {0.0F, 1.0F, 0.0F}}});
  builder.add_clip("clip", 1.0);
  return builder;
}

/// Returns why a builder builds nothing; empty if it builds.
inline std::string fault_of(const CharacterBuilder& builder) {
  const auto file = builder.build();
  return file ? "" : file.error().message;
}

}  // namespace throng::api_test
