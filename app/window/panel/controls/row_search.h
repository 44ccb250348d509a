#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace throng::app {

/// Returns whether a text has these letters, in upper or lower case. No letters are in every text.
bool has_letters(std::string_view text, std::string_view letters);

/// Finds the rows of all tabs that have every word of a text in their label, in their help text, in the
/// key of their value or in the title of their section. The tabs are gone through once for each pass.
class RowSearch {
 public:
  /// Rows that have the words in their label or key come first.
  enum class Pass : std::uint8_t { names, explanations };
  struct Place {
    std::string tab, section;
  };

  explicit RowSearch(std::string_view text);

  void begin_pass(Pass pass) { pass_ = pass; }
  void begin_tab(const char* name);
  void begin_section(const char* title);
  /// Returns whether this pass shows the row.
  bool finds(std::string_view label, std::string_view what, std::string_view key);

  /// Returns the place of the row that was found last, if it is the first of its section; nothing for later rows.
  [[nodiscard]] std::optional<Place> take_new_place();
  /// Asks to leave the search for that place.
  void leave_for(const Place& place) { wanted_ = place; }

  [[nodiscard]] std::size_t found() const { return found_; }
  /// Returns where the last row that was found is.
  [[nodiscard]] const Place& last_place() const { return last_; }
  [[nodiscard]] const std::optional<Place>& wanted_place() const { return wanted_; }

 private:
  std::vector<std::string> words_;
  Pass pass_ = Pass::names;
  Place now_, last_;
  bool is_new_ = false;  // the section has no row yet that was found
  std::size_t found_ = 0;
  std::optional<Place> wanted_;
};

}  // namespace throng::app
