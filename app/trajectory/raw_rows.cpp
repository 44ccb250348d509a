#include "app/trajectory/raw_rows.h"

#include <algorithm>

namespace throng::app {

bool add_row(const RawRow& row, RowSink& sink) {
  const double farthest = std::max({std::abs(row.x), std::abs(row.y), std::abs(static_cast<double>(row.z))});
  if (farthest > sink.most) {
    sink.fault = "a place lies more than 10,000 km off; put metres there, or give the unit with --unit";
    return false;
  }
  if (std::abs(row.time) > most_time) {
    sink.fault = "its time is thousands of years off; put seconds or frames there";
    return false;
  }
  sink.rows.push_back(row);
  return true;
}

}  // namespace throng::app
