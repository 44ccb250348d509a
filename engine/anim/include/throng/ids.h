#pragma once

#include <cstdint>

namespace throng {

/// Ids name things of a system. An id that was never given names nothing, and neither does the id of a removed thing: a
/// number is used again, and its generation tells its owners apart. Every call checks its ids.

inline constexpr std::uint32_t no_number = UINT32_MAX;
inline constexpr std::uint32_t whichever = UINT32_MAX;  ///< a generation: the present owner of the number

/// Names an agent of a system. A system gives ids with a generation; `AgentId{n}` names the agent with number n.
struct AgentId {
  std::uint32_t number = no_number;
  std::uint32_t generation = whichever;

  constexpr bool valid() const { return number != no_number; }
  friend constexpr bool operator==(AgentId, AgentId) = default;
};

/// Names a character of a system. The first is number 0; the numbers of characters that are removed are used again.
struct CharacterId {
  std::uint32_t number = no_number;
  std::uint32_t generation = whichever;

  constexpr CharacterId() = default;
  constexpr CharacterId(std::uint32_t own_number, std::uint32_t own_generation = whichever)
      : number(own_number), generation(own_generation) {}

  constexpr bool valid() const { return number != no_number; }
  friend constexpr bool operator==(CharacterId, CharacterId) = default;
};

/// Names a channel of an agent. An agent counts its channels from 0, and uses no number twice.
struct ChannelId {
  std::uint32_t number = no_number;

  constexpr bool valid() const { return number != no_number; }
  friend constexpr bool operator==(ChannelId, ChannelId) = default;
};

/// Names a post process of an agent. An agent counts its processes from 0, and uses no number twice.
struct ProcessId {
  std::uint32_t number = no_number;

  constexpr bool valid() const { return number != no_number; }
  friend constexpr bool operator==(ProcessId, ProcessId) = default;
};

/// Names a clip of a character, whichever system plays it. A character gives ids with the generation of the place where
/// the clip is; `ClipId{n}` names the clip at place n now.
struct ClipId {
  std::uint32_t number = no_number;
  std::uint32_t generation = whichever;

  constexpr bool valid() const { return number != no_number; }
  friend constexpr bool operator==(ClipId, ClipId) = default;
};

/// Names a crowd's weights for the bones of a character. An invalid id stands for all bones.
struct MaskId {
  std::uint32_t number = no_number;

  constexpr bool valid() const { return number != no_number; }
  friend constexpr bool operator==(MaskId, MaskId) = default;
};

}  // namespace throng
