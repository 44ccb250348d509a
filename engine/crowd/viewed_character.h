#pragma once

#include <cstdint>
#include <memory>

#include "engine/anim/bake/character.h"

namespace throng {

/// A character as a view shows it.
struct ViewedCharacter {
  std::shared_ptr<const anim::Character> character;
  std::uint32_t full_rate_nanoseconds = 0;  ///< the time of an agent that is posed in every frame, beside its clips
};

}  // namespace throng
