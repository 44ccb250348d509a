#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "app/character/source.h"
#include "engine/anim/agent/animation_system.h"
#include "engine/anim/base/aligned_bytes.h"
#include "engine/anim/base/transform.h"

namespace throng::app {

/// The joints of the poses that were written last: the place of each bone in model space. Nothing is kept until it is
/// asked for.
class KeptJoints {
 public:
  /// Has updates write the joints of these characters, which are the first of the system. Errors: those of
  /// anim::Characters::write_joints.
  Status begin(anim::AnimationSystem& system, std::span<const CharacterSource> characters);
  /// Makes room for that many agents. Call it before an update.
  void make_room(std::size_t agents);

  /// Returns where an update writes the joints of an agent; null while none are kept.
  std::byte* destination(std::uint32_t agent) const { return stride_ == 0 ? nullptr : memory(agent); }
  /// Returns [bone] the joints of an agent with so many bones, as it was updated last.
  std::span<const anim::PaletteMatrix> of(std::uint32_t agent, std::size_t bones) const {
    return {reinterpret_cast<const anim::PaletteMatrix*>(memory(agent)), bones};
  }

 private:
  std::byte* memory(std::uint32_t agent) const { return memory_.get() + stride_ * agent; }

  std::size_t stride_ = 0;  // bytes an agent; 0: none are kept
  std::size_t agents_ = 0;
  anim::AlignedBytes memory_;
};

}  // namespace throng::app
