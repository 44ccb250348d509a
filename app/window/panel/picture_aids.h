#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "app/window/panel/legend.h"
#include "app/window/panel/tabs.h"

namespace throng::app {

/// A figure above a head that was drawn in the frame before.
struct KeptHead {
  std::uint32_t agent = 0;
  int lines_up = 0;  ///< from the place above the head
};

/// All that the aids over the picture remember from frame to frame.
struct AidsMemory {
  bool legend_is_folded = false;
  bool is_legend_alone = false;  ///< in a picture: it cannot fold, and it says the time and how many people there are
  std::vector<KeptHead> heads;   ///< by agent
  float grabbed_beside = 0;      ///< pixels from the line of the split to where it was grabbed
};

/// Shows what helps to read the picture of the crowd: the line of a split, figures above heads, and the legend. They
/// keep clear of all that is shown over the crowd already, as `map` has it.
void show_picture_aids(const TabContext& context, const UiMap& map, const Area& crowd, AidsMemory& memory);

/// Shows the aids of a picture without a panel, over all of it: the legend where it stands alone, and ids above heads.
void show_aids_without_panel(const TabContext& context, AidsMemory& memory);

// Their parts. `taken` are the places over the crowd that must stay free.

/// Shows the grip of the line that splits the picture, and says what is on either side. A drag moves the line. Returns
/// the places of the grip and the words.
std::vector<Area> show_split_line(const TabContext& context, const Area& crowd, std::span<const Area> taken,
                                  AidsMemory& memory);
/// Writes above the heads of agents near by what is asked for: the id, the interval in frames, and after it the bone
/// level where bones are dropped. A figure that would lie over another one is left out.
void show_head_labels(const TabContext& context, const Area& crowd, std::span<const Area> taken, AidsMemory& memory);
/// Shows the meanings of the colours in the picture. Returns where, or nothing while there are none.
std::optional<Area> show_legend(const TabContext& context, const Area& crowd, std::span<const Area> taken,
                                AidsMemory& memory);

bool overlap(const Area& a, const Area& b);
/// Returns whether a place lies over none of the others.
bool is_free(const Area& place, std::span<const Area> taken);

}  // namespace throng::app
