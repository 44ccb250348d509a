#include "engine/tracks/raw_rows.h"

#include <utility>

namespace throng {

bool add_row(const RawRow& row, RowSink& sink) {
  const auto is_near = [&](double place) { return std::abs(place) <= sink.most; };  // false for NaN, too
  if (!is_near(row.x) || !is_near(row.y) || !is_near(static_cast<double>(row.z))) {
    sink.fault = "a place lies more than 10,000 km off; put metres there, or give the unit with --unit";
    return false;
  }
  if (!(std::abs(row.time) <= most_time)) {
    sink.fault = "its time is thousands of years off; put seconds or frames there";
    return false;
  }
  sink.rows.push_back(row);
  return true;
}

RawRows take_rows_of(RowSink& sink) {
  RawRows rows = std::exchange(sink.rows, {});
  sink.rows.reserve(rows.size() + rows.size() / 16);
  return rows;
}

}  // namespace throng
