#pragma once

#include <cstddef>
#include <initializer_list>

#include "app/character/roles.h"
#include "app/people/crowd/cast.h"

namespace throng::app {

/// Returns a character with these roles, whose clips are numbered in the order of Role.
inline CharacterRoles character_with(std::initializer_list<Role> roles) {
  CharacterRoles character;
  for (const Role role : roles) character.clips[index_of(role)] = static_cast<int>(index_of(role));
  character.walk_speed = 1.3;
  character.jog_speed = 2.4;
  character.run_speed = 3.9;
  character.walk_seconds = 1.1;
  return character;
}

/// Returns somebody who can do everything.
inline CharacterRoles person() {
  return character_with({Role::stand, Role::look_around, Role::walk, Role::jog, Role::run, Role::wave, Role::cheer,
                         Role::clap, Role::sit});
}

/// Returns the cast of agents that stand about, all of one character.
inline CrowdCast standing(const CharacterRoles& character, std::size_t agents) {
  CrowdLayout layout;
  layout.standers.resize(agents);
  return {{&character, 1}, layout, 1};
}

}  // namespace throng::app
