#include "app/overlay/bone_order_edit.h"

#include <algorithm>

namespace throng::app {

BoneLodChoice taken_back(const BoneLodChoice& choice, const std::vector<int>& level_counts) {
  BoneLodChoice back{.bones = std::vector<int>(choice.bones.size()), .level_counts = level_counts};
  for (std::size_t place = 0; place < choice.bones.size(); ++place) {
    back.bones[static_cast<std::size_t>(choice.bones[place])] = static_cast<int>(place);
  }
  return back;
}

BoneLodChoice with_border_moved(BoneLodChoice choice, std::size_t level, int bones) {
  std::vector<int>& counts = choice.level_counts;
  const auto last = static_cast<int>(counts.size()) - 1, moved = static_cast<int>(level);
  counts[level] = std::clamp(bones, 1 + last - moved, counts.front() - moved);
  for (std::size_t i = level; i-- > 1;) counts[i] = std::max(counts[i], counts[i + 1] + 1);
  for (std::size_t i = level + 1; i < counts.size(); ++i) counts[i] = std::min(counts[i], counts[i - 1] - 1);
  return choice;
}

}  // namespace throng::app
