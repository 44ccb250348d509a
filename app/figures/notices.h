#pragma once

#include <span>
#include <string>

#include "app/character/source.h"
#include "app/lod/shown_poses.h"
#include "engine/anim/agent/animation_system.h"

/// What a run does otherwise than a person would expect: a sentence each, empty where there is nothing to say.
namespace throng::app {

/// What is spared where a processor draws live and nobody asked otherwise.
struct Spared {
  int agents = 0;  ///< as many as there are instead; 0: as many as asked for
  bool multisampling = false, shadows = false, mesh_detail = false;
};
std::string software_notice(const std::string& renderer, const Spared& spared);

/// An automatic local store that had to be larger than usual.
std::string local_store_notice(const anim::AnimationSystem& system);

/// Agents in view that found no room for their palettes.
std::string palette_notice(const ShownPoses& shown);

/// Characters whose palettes stay float although packed ones were asked for; the first ones of the system.
std::string palette_format_notice(const anim::AnimationSystem& system, std::span<const CharacterSource> characters);

/// `sentence` on a line of its own; an empty one adds none.
void add_line(std::string& lines, const std::string& sentence);

}  // namespace throng::app
