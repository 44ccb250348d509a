#pragma once

#include <cstddef>
#include <string>

#include "app/window/panel/hotkeys.h"
#include "app/window/panel/tabs.h"
#include "app/window/panel/viewer_panel.h"

namespace throng::app {

/// The panel's column at the right: a header, and below it the tabs, or the viewer of one character in their place.
class PanelColumn {
 public:
  explicit PanelColumn(Widgets& widgets) : widgets_(widgets), theme_(widgets.theme()) {}

  /// Shows a field to search in, and the tabs, or the found rows in them. A person changes `switches` there.
  void show_tabs(const Area& place, const TabContext& context, OverlaySwitches& switches);
  /// Shows the viewer; the report must have one.
  void show_viewer(const Area& place, const TabContext& context, OverlaySwitches& switches);

  /// Goes to the tab of that name; a name that no tab has is ignored.
  void go_to(const std::string& tab);
  /// Returns the name of the tab that is shown, or that comes back after the viewer.
  [[nodiscard]] const char* tab() const;

 private:
  void begin(const Area& place, OverlaySwitches& switches);
  void show_header(const Area& place, OverlaySwitches& switches);
  bool show_header_word(const Area& line, const char* name, bool with_key);
  void show_search_field(const Area& place, OverlaySwitches& switches);
  void show_tab_bar(const Area& place, OverlaySwitches& switches);
  void show_tab_name(std::size_t tab, const Area& area, OverlaySwitches& switches);
  void show_found(const TabContext& context, OverlaySwitches& switches);
  void change_tab(int further, OverlaySwitches& switches);
  void leave_search_for(const RowSearch::Place& place, OverlaySwitches& switches);
  template <class Show>
  void show_below(const Area& place, float top, const char* name, const Show& show);

  Widgets& widgets_;
  const Theme& theme_;
  std::size_t tab_ = 0;
  bool wants_the_only_one_ = false;  ///< Enter was pressed in the field of the search
  ViewerPanelMemory viewer_;
};

}  // namespace throng::app
