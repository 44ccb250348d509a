#include "tests/soak/finite_poses.h"

#include <cmath>
#include <cstring>
#include <string>

#include "throng/heap_pages.h"

#include "app/show/painter.h"
#include "app/show/stage/stage.h"
#include "engine/crowd/palette_slots.h"

namespace throng::soak {
namespace {

bool is_finite(const glm::vec3& place) {
  return std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z);
}

bool is_finite(const std::byte* matrices, std::size_t entries) {
  constexpr std::size_t numbers_an_entry = 12;
  for (std::size_t i = 0; i < entries * numbers_an_entry; ++i) {
    float number = 0;
    std::memcpy(&number, matrices + i * sizeof(number), sizeof(number));
    if (!std::isfinite(number)) return false;
  }
  return true;
}

/// Packed palettes are integers, which are always numbers.
bool is_finite(const HeapPageSource& pages, const PaletteSlot& slot, PaletteFormat format, std::uint32_t entries) {
  if (!slot.valid() || format == PaletteFormat::packed) return true;
  return is_finite(pages.memory(slot.page) + slot.first_line * render::palette_line_bytes, entries);
}

}  // namespace

Fault number_that_is_none(app::Show& show) {
  const app::Stage& stage = show.stage();
  const auto* const pages = dynamic_cast<const HeapPageSource*>(&show.painter().palette_pages());
  for (std::uint32_t agent = 0; agent < stage.crowd().size(); ++agent) {
    const std::string who = "agent " + std::to_string(agent) + " (" + stage.character_of(agent).name + ")";
    if (!is_finite(stage.crowd().positions()[agent])) return who + " is nowhere";
    if (pages == nullptr) continue;
    const ShownPose& pose = stage.posed().pose_of(agent, Poses::shown);
    const auto& entries = stage.character_of(agent).character->level_entries;
    if (!is_finite(*pages, pose.from, pose.from_format, entries[pose.from_level]) ||
        !is_finite(*pages, pose.to, pose.to_format, entries[pose.to_level])) {
      return "the palette of " + who + " has a number that is none";
    }
  }
  return {};
}

}  // namespace throng::soak
