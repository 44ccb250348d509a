#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/settings/idle_values.h"
#include "app/settings/settings.h"
#include "app/settings/tuning_pair.h"
#include "app/settings/tuning_values.h"
#include "app/show/report/frame_report.h"
#include "app/show/request/requests.h"
#include "app/window/panel/controls/widgets.h"
#include "app/window/panel/notices.h"

namespace throng::app {

/// The cost of a value that decides who is in the crowd.
inline constexpr const char* places_all_anew = "All agents get new places.";

/// All that the list of bones remembers from frame to frame.
struct BoneListMemory {
  struct Drag {
    std::size_t from = 0;  ///< place in the list; of a border, the level that ends there
    bool border = false;
    std::size_t over = 0;  ///< the row under the pointer
  };
  std::string search;
  std::optional<Drag> drag;
};

/// All that the tabs remember from frame to frame.
struct TabMemory {
  BoneListMemory bones;
  std::optional<SetPlacement> placement;     ///< a size or a place that is being dragged
  std::optional<TuneRules> rules;            ///< rules whose value is being dragged
  bool shows_styles = false;                 ///< the list of styles is open
  bool shows_body = false;                   ///< the list of the parts of the body is open
  bool shows_gaits = false;                  ///< the list of roles that only trajectories ask for is open
  SweptValue swept = SweptValue::tile;       ///< the value that the next sweep varies
  float timeline_from = 0, timeline_to = 1;  ///< the part of the timeline that is seen, in shares of its length
  std::size_t entity = SIZE_MAX;             ///< the entity whose block is shown; past the end: the last
  std::optional<double> seconds_back;        ///< where the slider over snapshots is dragged to
  TuningPair pair;                           ///< key B changes their places
  NoticeMemory notices;
  std::string searched_help;
  std::string rules_name;
  std::string preset_name, crowd_name, about_to_delete;  ///< a preset is deleted when it is asked for a second time
};

/// All that a tab reads and may change.
struct TabContext {
  Widgets& widgets;
  const FrameReport& report;
  Tuning& tuning;
  const Tuning& standard;  ///< the defaults to go back to
  Requests& requests;      ///< of this frame, to be added to
  TabMemory& memory;

  /// Shows the tuning's value with that key. The table of values gives name, kind, range, words and default. A value
  /// that has no effect is shown as disabled, with the reason. Returns whether the person changed the value.
  bool row(const char* key, const Help& help) const { return row(key, scale_of(key), help); }
  bool row(const char* key, const NumberScale& scale, const Help& help) const;

  /// Shows the rows of `show` as disabled, with the reason, where the value with that key has no effect (idle_reason).
  template <typename Show>
  void unless_idle(std::string_view key, const Show& show) const {
    widgets.begin_idle(idle_reason(key, tuning, report.situation), key);
    show();
    widgets.end_idle();
  }

  /// Shows a part of a tab that has no rows, such as a plot. While values are searched it is left out.
  void when_not_searching(void (*show)(const TabContext& context)) const {
    if (!widgets.is_searching()) show(*this);
  }

 private:
  bool edit(const TuningValue& row, const NumberScale& scale, const Help& help) const;
};

/// Returns the number of bone levels of the character shown: four, unless it has fewer.
int level_count(const FrameReport& report);
/// Shows the level that the person forces on agents.
void show_forced_level(const TabContext& context, const char* label, const char* what);

void show_crowd_tab(const TabContext& context);
void show_lod_skipping_tab(const TabContext& context);
void show_bone_lod_tab(const TabContext& context);
void show_scheduling_tab(const TabContext& context);
void show_agent_tab(const TabContext& context);
void show_presets_tab(const TabContext& context);

/// Shows how the meshes of the character shown are chosen, and what follows.
void show_meshes(const TabContext& context);
/// Shows the size and place of the character shown, and why it has them.
void show_model(const TabContext& context);
/// Shows which agents wear what: bodies, styles and things in hands, and the files of such rules.
void show_wardrobe(const TabContext& context);
/// Shows the cameras of the scene and of the person, what moves the camera, and how fast it flies.
void show_camera_section(const TabContext& context);
/// Shows what is drawn, in which size and how well, in Crowd (picture_section.cpp).
void show_picture_section(const TabContext& context);
/// Shows the parts of the character's body with their bones, in a list that opens: a person chooses other bones, keeps
/// them, and reads what follows from them.
void show_body(const TabContext& context);
/// Shows the error on the screen: figures, number of samples, the interval that chance gives them, and their history
/// beside the limit.
void show_error(const TabContext& context);
/// Shows a sweep over the crowd that runs: the value to vary, a button, and the curve. A click on a stop takes its
/// value.
void show_sweep(const TabContext& context);
/// Shows the work of each PU in the last frames, or in a kept frame, side by side on one axis of
/// milliseconds. The wheel zooms about the pointer, a drag moves along, and a double click shows all again. A span
/// under the pointer says what it was.
void show_timeline(const TabContext& context);

}  // namespace throng::app
