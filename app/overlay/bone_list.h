#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/character/bone_lod.h"
#include "app/overlay/tabs.h"

namespace throng::app {

/// The bones in level-of-detail order, with what each costs and what is lost without it. A bone is dragged to another
/// place, and so is the line at which a level ends; each change can be taken back.
class BoneList {
 public:
  void show(const TabContext& context);

  /// Changes that can be taken back.
  [[nodiscard]] std::size_t changes() const { return undo_.size(); }

 private:
  struct Drag {
    std::size_t from = 0;  ///< place in the list; of a border, the level that ends there
    bool border = false;
    std::size_t over = 0;  ///< the row under the pointer
  };

  void show_search(const TabContext& context);
  void show_buttons(const TabContext& context);
  void show_row(const TabContext& context, std::size_t place);
  void show_border(const TabContext& context, int level, std::size_t bones);
  void finish_drag(const TabContext& context);
  void change(const TabContext& context, const BoneLodChoice& choice);
  [[nodiscard]] bool matches(const BoneRow& bone) const;

  std::string search_;
  std::size_t character_ = 0;
  std::optional<Drag> drag_;
  std::vector<BoneLodChoice> undo_;  ///< each takes the order after it back to the one before
};

}  // namespace throng::app
