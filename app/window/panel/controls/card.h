#pragma once

#include <string>

#include "app/window/panel/controls/widgets.h"

namespace throng::app {

/// A window over the crowd with a title. A person moves it by its title, folds and closes it; what does not fit is
/// scrolled to. It stays inside of the crowd's area and covers at most a fifth of it, unless its layout allows more.
///
///   if (Card card(widgets, "Help", crowd, {.at = ..., .size = ...}); card.is_unfolded()) { ... }
class Card {
 public:
  static constexpr float usual_share = 0.2F;
  struct Layout {
    ImVec2 at;                 ///< its place at first
    ImVec2 size;               ///< of all that it holds, without the title; a card gets less where that is too much
    std::string title = {};    ///< empty: its name
    float most = usual_share;  ///< the share of the crowd's area that it may cover
  };

  Card(Widgets& widgets, const char* name, const Area& crowd, const Layout& layout);
  ~Card();
  Card(const Card&) = delete;
  Card& operator=(const Card&) = delete;

  /// Returns whether its content is to be shown.
  [[nodiscard]] bool is_unfolded() const { return is_unfolded_; }
  /// Returns whether the person closed it in this frame.
  [[nodiscard]] bool was_closed() const { return !stays_open_; }
  /// Returns the place of all that it holds, as far as it is scrolled.
  [[nodiscard]] Area content() const { return content_; }

  /// Returns the height of the content that a card of that width, which covers at most that share of the crowd's area,
  /// holds without a need to scroll.
  static float most_height(const Theme& theme, const Area& crowd, float width, float most = usual_share);

 private:
  bool stays_open_ = true;
  bool is_unfolded_ = false;
  Area content_;
};

}  // namespace throng::app
