#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "throng/crowd.h"

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/agent/blend_space_2d_channel.h"
#include "engine/anim/api/character_data.h"
#include "engine/anim/api/own_kinds.h"

namespace throng::detail {

// The reasons why a call with such an id is refused.
inline constexpr const char* no_agent = "an agent of this id is not in the crowd";
inline constexpr const char* no_character = "a character of this id is not in the crowd";
inline constexpr const char* was_moved_from = "it was moved from";

/// Notes of each agent, by number, which level of detail reads.
struct AgentNotes {
  std::vector<std::uint8_t> characters;  // [agent]
  std::vector<int> clips;                // [agent] the clip that it was asked for last; -1: none
  std::vector<Ticks> fades_until;        // [agent] the end of the fade that was asked for last
  std::vector<std::uint32_t> requests;   // [agent] counts requests for clips
};

/// A character of a crowd, and the kinds of entities that its agents' processes have made need of.
struct CrowdCharacter {
  Character character;
  std::unique_ptr<OwnKinds> kinds;
};

/// The points of the blend spaces that agents were given last. The next agents share them if theirs are equal.
struct LastSpaces {
  std::shared_ptr<const std::vector<anim::BlendPoint>> line;
  std::shared_ptr<const anim::BlendSpace2d> plane;
};

/// A row of a matrix, aligned as palettes are.
struct alignas(16) PaletteRow {
  float numbers[4];
};

/// The inside of a Crowd: an AnimationSystem, and what the public calls keep beside it.
struct CrowdParts {
  std::vector<CrowdCharacter>
      characters;  // [number] an empty one where no character has the number. They outlive the system.
  std::unique_ptr<anim::AnimationSystem> system;
  AgentNotes notes;
  LastSpaces spaces;
  std::vector<anim::ExactPose> exact;       // scratch of a look
  std::vector<anim::Transform> locals;      // scratch of a look
  std::vector<PaletteRow> rows;             // scratch of Crowd::bounds, three an entry
  std::vector<std::vector<AgentKey>> keys;  // [run of agents] of ManyAgents::keys; the first has all of them
  std::uint64_t version = 0;                // another one, of all crowds, whenever characters come or go
  std::uint64_t number = 0;                 // its first version, so another one than any crowd's

  /// Returns the character of an agent; null, after a report, if the agent is gone.
  CrowdCharacter* character_of(AgentId agent, const char* call);
  /// Returns why an agent cannot play the clip of an id that it could once play, in one sentence; else null. Every
  /// request for a clip asks it first. The system checks everything else.
  const char* fault_of(AgentId agent, ClipId clip) const;
  /// Returns whether an agent is in the crowd; else reports a misuse.
  bool has(AgentId agent, const char* call) const;
  /// Returns whether both times are within a day of the clock; else reports a misuse.
  bool are_near(Ticks from, Ticks to, const char* call) const;
  /// Returns whether keys may be asked for between these times: are_near(), in their order, and a minute at most.
  bool is_asked_in_time(Ticks from, Ticks to, const char* call) const;
  /// Notes which clip an agent plays.
  void note_clip(AgentId agent, ClipId clip, Ticks fade = {}) {
    if (agent.number < notes.clips.size()) notes.clips[agent.number] = static_cast<int>(clip.number);
    note_request(agent, fade);
  }
  /// Notes that an agent was asked for a clip, so that level of detail shows it in the next frame.
  void note_request(AgentId agent, Ticks fade) {
    if (agent.number >= notes.requests.size()) return;
    notes.fades_until[agent.number] = system->clock() + fade;
    ++notes.requests[agent.number];
  }
};

/// Returns the baked part of a character as a system takes it.
inline std::shared_ptr<const anim::Character> baked_of(const Character& character) { return character.data()->baked; }

}  // namespace throng::detail
