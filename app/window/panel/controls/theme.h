#pragma once

#include <cstddef>
#include <filesystem>

#include <imgui.h>

#include "engine/render/passes/imgui_versions.h"

namespace throng::app {

namespace imgui = render::imgui;
using imgui::font_height;

/// The colours of the overlay, packed as Dear ImGui wants them. They are few, because people should look at the crowd.
namespace colour {
inline constexpr ImU32 panel = IM_COL32(16, 19, 24, 241);
inline constexpr ImU32 panel_edge = IM_COL32(255, 255, 255, 18);
inline constexpr ImU32 well = IM_COL32(255, 255, 255, 13);
inline constexpr ImU32 well_hovered = IM_COL32(255, 255, 255, 28);
inline constexpr ImU32 text = IM_COL32(229, 233, 238, 255);
inline constexpr ImU32 dim = IM_COL32(146, 156, 169, 255);
inline constexpr ImU32 faint = IM_COL32(96, 105, 117, 255);
inline constexpr ImU32 grid = IM_COL32(255, 255, 255, 16);
inline constexpr ImU32 accent = IM_COL32(72, 191, 174, 255);
inline constexpr ImU32 accent_soft = IM_COL32(72, 191, 174, 64);
inline constexpr ImU32 on_accent = IM_COL32(9, 26, 24, 255);
inline constexpr ImU32 focus = IM_COL32(255, 255, 255, 210);
inline constexpr ImU32 changed = IM_COL32(240, 178, 84, 255);
inline constexpr ImU32 recording = IM_COL32(232, 84, 84, 255);
inline constexpr ImU32 fetch = IM_COL32(88, 140, 236, 255);
inline constexpr ImU32 compute = IM_COL32(72, 191, 174, 255);
inline constexpr ImU32 write_back = IM_COL32(182, 122, 232, 255);
inline constexpr ImU32 wait = IM_COL32(72, 79, 90, 255);
inline constexpr ImU32 frame = IM_COL32(122, 178, 232, 255);

ImU32 with_alpha(ImU32 colour, float alpha);
/// Returns the colour that debug views lay over an agent that is updated every so many frames, opaque.
ImU32 interval(int frames);
ImU32 bone_level(int level);
/// Returns the colour of words that lie on that one.
ImU32 ink_on(ImU32 ground);
}  // namespace colour

/// Fonts and measures; a length written in pixels of a plain screen is multiplied by the scale of the overlay.
struct Theme {
  float scale = 1;
  ImFont* regular = nullptr;  ///< 15 pixels
  ImFont* strong = nullptr;   ///< 15 pixels, headings
  ImFont* small = nullptr;    ///< 13 pixels, captions and tables
  ImFont* large = nullptr;    ///< 22 pixels, the numbers that matter most
  bool fonts_missing = false;
  bool panels_have_ground = true;  ///< false: the renderer of the overlay fills the place of the panels before

  [[nodiscard]] float px(float pixels) const { return pixels * scale; }
};

/// Loads Roboto from `fonts` into the current ImGui context (its own bitmap font where the files are missing) and sets
/// colours, rounding and spacing there.
Theme apply_theme(const std::filesystem::path& fonts, float scale);

}  // namespace throng::app
