#include "app/overlay/entity_words.h"

#include "app/overlay/numbers.h"

namespace throng::app {

std::string place_in_clip(const EntityRow& row) {
  if (row.duration_seconds <= 0) return "";
  return fixed(static_cast<double>(row.position_seconds), 2) + " / " +
         fixed(static_cast<double>(row.duration_seconds), 2);
}

std::string as_percent(float weight) { return fixed(100 * static_cast<double>(weight), 0) + " %"; }

}  // namespace throng::app
