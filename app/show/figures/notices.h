#pragma once

#include <span>
#include <string>

#include "app/character/source.h"
#include "app/people/wardrobe/clothing.h"
#include "engine/anim/agent/animation_system.h"
#include "engine/crowd/shown_poses.h"
#include "engine/tracks/trajectories.h"

/// Sentences on the ways in which a run differs from a person's expectation. Each is empty where it does not.
namespace throng::app {

/// The values that the device decides, since the command line does not. A value of 0 or false leaves what was asked
/// for. Where a processor draws live, they save work.
struct DeviceChoices {
  int agents = 0;
  bool no_multisampling = false, no_shadows = false;
  float error_px = 0;
  int triangles = 0;        ///< of all agents in view, at most
  bool holds_rate = false;  ///< a window holds a frame rate
  float frame_rate = 0;
};
/// Says what a processor leaves out; empty where it leaves out nothing.
std::string software_notice(const std::string& renderer, const DeviceChoices& choices);

/// Says what import repaired and left out of the characters' files, up to three lines each, how they were changed after
/// import, and which other characters the files have.
std::string import_notice(std::span<const CharacterSource> characters);

/// Says, in a line each, which characters are not shown in the size and place of their files, and why.
std::string placement_notice(std::span<const CharacterSource> characters);

/// Says the doubts of the rules that dress people, up to four lines for each file of rules.
std::string rules_notice(std::span<const Clothing> clothing);

/// Describes a recorded crowd: its people, the reader's findings, and how many oddities `throng inspect` lists.
std::string tracks_notice(const Trajectories& trajectories);
/// Says that the walls and floors of a recorded crowd are too many to be drawn.
std::string plan_notice(std::size_t lines, std::size_t most);

/// Says that an automatic local store had to be larger than usual.
std::string local_store_notice(const anim::AnimationSystem& system);

/// Says that fewer PUs run than were asked for, because the system has no more threads.
std::string pu_notice(int asked, int running);

/// Says how many agents in view have no room for their palettes.
std::string palette_notice(const ShownPoses& shown);

/// Names the characters whose palettes stay float although packed ones were asked for.
std::string palette_format_notice(const anim::AnimationSystem& system, std::span<const CharacterSource> characters);

/// Names the characters that play from rows although keys were asked for.
std::string stream_notice(const anim::AnimationSystem& system, std::span<const CharacterSource> characters);

/// Adds `sentence` on a line of its own; an empty one adds no line.
void add_line(std::string& lines, const std::string& sentence);

}  // namespace throng::app
