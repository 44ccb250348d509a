#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "app/window/panel/controls/numbers.h"
#include "app/window/panel/controls/panel_focus.h"
#include "app/window/panel/controls/row_search.h"
#include "app/window/panel/controls/theme.h"
#include "app/window/panel/controls/ui_map.h"
#include "app/window/panel/controls/words.h"

namespace throng::app {

/// The tooltip of a value; its default is added from the value itself.
struct Help {
  const char* what = "";
  const char* unit = "";
  const char* cost = "";
};

/// A rectangle of the screen to draw into.
struct Area {
  ImVec2 from, to;
  bool hovered = false;

  [[nodiscard]] float width() const { return to.x - from.x; }
  [[nodiscard]] float height() const { return to.y - from.y; }
};

/// Returns whether a control beside its label would have no room in that width.
bool is_narrow(const Theme& theme, float width);

/// The rows of the tabs: a label, a control, and a way back to the default. Each row looks the same, shows its help
/// when the pointer rests on it, marks a value that is not the default, and notes its rectangles in the map.
class Widgets {
 public:
  Widgets(const Theme& theme, UiMap& map) : theme_(theme), map_(map) {}

  [[nodiscard]] const Theme& theme() const { return theme_; }

  /// Shows the rows until end_idle() as disabled if there is a reason why they have no effect. The tooltip of each
  /// row has the reason, and the map lists it. They do not nest. `key` is the key of the value that the rows edit.
  void begin_idle(std::optional<std::string> reason, std::string_view key = {});
  void end_idle();

  /// From now on, leaves out the rows that `search` does not find, and all that is no row. Null: shows all again.
  void search_in(RowSearch* search) { search_ = search; }
  [[nodiscard]] bool is_searching() const { return search_ != nullptr; }
  /// Scrolls to the next section of that title that is shown.
  void scroll_to_section(const std::string& title) { wanted_section_ = title; }

  void section(const char* title);
  /// Shows a title that a click folds. Returns whether the rows below it are to be shown. It stays folded until a click
  /// or a search leads to it.
  bool folding_section(const char* title);
  bool number(const char* label, double& value, double standard, const NumberScale& scale, const Help& help);
  bool number(const char* label, float& value, float standard, const NumberScale& scale, const Help& help);
  bool toggle(const char* label, bool& value, bool standard, const Help& help);
  bool button(const char* label, const Help& help, float width) { return named_button(label, label, help, width); }
  /// Shows a button that shares its words with others; `name` tells it apart in the map.
  bool named_button(const char* words, const std::string& name, const Help& help, float width);
  /// Shows a field for a few words, at most 63 bytes. `hint` stands in it while it is empty.
  bool text(const char* label, std::string& value, const char* hint, const Help& help);
  /// Shows a field alone, at that place, for as many bytes.
  bool text_field(const std::string& name, std::string& value, const char* hint, const Area& place,
                  std::size_t most_bytes = 63);
  void fact(const char* label, const std::string& value, const Help& help);
  void caption(const std::string& text) const;
  /// Shows a sentence that comes and goes. It always takes the room of three lines, so that nothing below it moves.
  void steady_caption(const std::string& text) const;

  /// Offers one of several words. The enumerators count from 0 in the order of `words`.
  template <class Choice>
  bool choice(const char* label, Choice& value, Choice standard, std::span<const char* const> words, const Help& help) {
    int index = static_cast<int>(value);
    const bool changed = choose(label, index, static_cast<int>(standard), words, help);
    value = static_cast<Choice>(index);
    return changed;
  }
  /// `why_not` has the reason why a word cannot be chosen now, or null, for each word; empty: all can be.
  bool choose(const char* label, int& index, int standard, std::span<const char* const> words, const Help& help,
              std::span<const char* const> why_not = {});

  /// Offers one of many words, from a list that opens. `none` is its first entry, index -1; null: the list has no such
  /// entry.
  bool pick(const char* label, int& index, int standard, std::span<const std::string> words, const char* none,
            const Help& help);

  /// Returns an area for a picture named `name`. It takes all of the width that is left, and `height` pixels of a plain
  /// screen. There is no area while values are searched (TabContext::when_not_searching).
  Area area(const char* name, float height);

  /// Returns whether a tab or another plain word was clicked, or activated by the keyboard. The caller draws it into
  /// the rectangle.
  bool clickable(const std::string& name, const Area& place);
  /// Notes a place that explains itself under the pointer; returns whether it was clicked. The keyboard passes it by.
  bool hoverable(const std::string& name, const Area& place) { return invisible(name, place, false); }
  /// Notes a place that takes clicks, where the keyboard stops at something else, such as its row. Returns whether it
  /// was clicked.
  bool pressable(const std::string& name, const Area& place) { return invisible(name, place, true); }
  /// Lets the keyboard stop at the thing that was shown under that name. Returns the focus, to take its keys.
  PanelFocus& stop(const std::string& name, const Area& place);
  [[nodiscard]] PanelFocus& focus() { return focus_; }
  /// Explains something at the height of the pointer, beside the column.
  void tooltip(const char* title, const Help& help, const std::string& standard) const;
  /// Notes a place in the map, as far as the window shows it.
  void record(const std::string& name, const Area& place, bool takes_clicks = false);
  /// Notes a place over the crowd that other things over the crowd keep clear of.
  void cover(const Area& place);
  /// Notes a place in the map that nothing cuts off.
  void record_whole(const std::string& name, const Area& place, bool takes_clicks = false);

 private:
  using FieldText = std::array<char, 32>;
  struct Row {
    const char* label;
    Help help;
    std::string standard;
    Area all, control;
    bool changed = false;   ///< it is not the default
    bool reset = false;     ///< asked for in this frame, by the arrow, a double click on the label or a key
    bool explains = false;  ///< the keyboard rests on it
    bool is_narrow = false;
  };

  /// The words of a choice, with the reasons why some cannot be chosen.
  struct Words {
    std::span<const char*const> all, why_not;

    [[nodiscard]] const char* reason(int index) const {
      return why_not.empty() ? nullptr : why_not[static_cast<std::size_t>(index)];
    }
    /// Returns the next word that can be chosen, so many steps further; the present one where there is none.
    [[nodiscard]] int next(int index, int steps, bool goes_round) const;
  };
  void choose_in_line(const char* label, const Area& line, const Words& words, int first, int last, int& index);
  void show_word(const char* label, const Area& place, const Words& words, int word, int& index);
  bool invisible(const std::string& name, const Area& place, bool takes_clicks);
  void tooltip_at(float y, const char* title, const Help& help, const std::string& standard) const;
  bool is_left_out(const char* label, const Help& help);
  void go_to_wanted_section(const char* title);
  void draw_title(const std::string& title, float free_at_the_right) const;
  void show_found_place(const RowSearch::Place& place);
  Row begin_row(const char* label, bool changed, const Help& help, const std::string& standard);
  [[nodiscard]] Area line_below(Row& row, float height) const;
  [[nodiscard]] Area room_for_words(Row& row) const;
  void stop_at(Row& row, const std::string& name);
  /// Returns whether the value has to go back to its default.
  bool end_row(Row& row);
  bool reset_arrow(const char* label, const Area& row);
  bool drag_track(const char* label, const Area& place, double& value, double standard, const NumberScale& scale);
  bool type_field(const char* label, const Area& place, double& value, const NumberScale& scale, bool begins);
  void show_list(const char* label, int& index, std::span<const std::string> words, const char* none);

  const Theme& theme_;
  UiMap& map_;
  RowSearch* search_ = nullptr;  ///< null: all is shown
  PanelFocus focus_;
  int list_place_ = -1;                 ///< the word of the open list that keys have come to
  std::string wanted_section_;          ///< empty: none is scrolled to
  std::set<std::string> folded_;        ///< the titles of sections that the person has folded
  std::string_view key_;                ///< of the value that the rows that are shown now edit
  std::optional<std::string> idle_;     ///< why the rows that are shown now have no effect
  std::map<ImGuiID, FieldText> typed_;  ///< text of the field that is typed into; two while one is left for another
  ImGuiID held_after_reset_ = 0;        ///< the track that a double click reset, until the button is let go
};

/// Buttons of equal width, side by side over all of the width that is left; two in a line where that is narrow.
class ButtonRow {
 public:
  ButtonRow(Widgets& widgets, int count);
  /// Shows the next button to the right. `idle` is why it does nothing now; null: it does something. Returns whether it
  /// was pressed.
  bool button(const char* label, const Help& help, const char* idle = nullptr);
  /// Shows such a button, which asks for something when it is pressed.
  void ask(auto& requests, auto asked, const char* label, const Help& help, const char* idle = nullptr) {
    if (button(label, help, idle)) requests.ask(std::move(asked));
  }
  /// Shows the next one under a name of its own, with a line under its words if it is `marked`.
  bool marked_button(const char* words, const std::string& name, const Help& help, bool marked);

 private:
  void go_right();

  Widgets& widgets_;
  int in_a_line_;
  float width_;
  int shown_ = 0;
};

/// Shows one button over all of the width that is left.
bool wide_button(Widgets& widgets, const char* label, const Help& help, const char* idle = nullptr);

/// Draws the sign beside a title that a click folds: it points down where the part below is shown, else up.
void draw_fold_sign(const Theme& theme, ImVec2 middle, bool is_folded, ImU32 ink);

/// Returns a rectangle that knows whether the pointer is over it.
Area rectangle(ImVec2 from, ImVec2 to);

}  // namespace throng::app
