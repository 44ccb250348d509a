#include "app/show/stage/memory_needs.h"

#include <algorithm>
#include <string>

#include "app/files/memory_check.h"
#include "app/show/stage/animated_crowd.h"
#include "engine/anim/base/pose.h"
#include "engine/base/text/joined.h"
#include "engine/base/text/size_text.h"

namespace throng::app {
namespace {

/// An agent takes so much for its blocks, its place and its figures. A run of 100,000 agents was measured.
constexpr std::uint64_t bytes_an_agent = 3000;

std::uint64_t bytes_of_crowd(int agents, std::span<const CharacterSource> characters) {
  std::uint64_t largest = 0;
  for (const CharacterSource& source : characters) {
    const auto entries = static_cast<std::uint64_t>(source.character->skeleton.palette_count());
    largest = std::max(largest, entries * sizeof(anim::PaletteMatrix));
  }
  return static_cast<std::uint64_t>(agents) * (bytes_an_agent + largest);
}

/// Returns how much more is needed than before.
std::uint64_t above(std::uint64_t needed, std::uint64_t taken) { return needed - std::min(needed, taken); }

}  // namespace

std::uint64_t bytes_of_pus(const anim::SystemOptions& options) {
  constexpr std::uint64_t shares = 2;  // the store, and lists of its possible blocks
  return static_cast<std::uint64_t>(on_this_machine(options).pus) * options.local_store_bytes * shares;
}

Status check_memory(const Tuning& tuning, std::span<const CharacterSource> characters, const Tuning* before) {
  const std::uint64_t pus = before == nullptr ? 0 : bytes_of_pus(before->system);
  const std::string units = counted(static_cast<std::size_t>(on_this_machine(tuning.system).pus), "PU") +
                            " with local stores of " + size_text(tuning.system.local_store_bytes);
  Status fits =
      check_memory(units, above(bytes_of_pus(tuning.system), pus), "ask for fewer --pus or a smaller --local-store");
  if (!fits) return fits;
  const std::uint64_t crowd = before == nullptr ? 0 : bytes_of_crowd(before->agents, characters);
  return check_memory(counted(static_cast<std::size_t>(tuning.agents), "agent"),
                      above(bytes_of_crowd(tuning.agents, characters), crowd), "ask for fewer --agents");
}

}  // namespace throng::app
