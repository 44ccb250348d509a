#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>

#include "engine/tracks/raw_rows.h"
#include "engine/tracks/reading.h"
#include "engine/tracks/text/xml_text.h"

namespace throng {

/// Reads the XML that SUMO writes (FCD), piece by piece: the people, and the vehicles where there are no people.
class FcdParser final : public XmlReader {
 public:
  /// Rows go to `sink`, which outlives the parser.
  FcdParser(RowSink& sink, bool is_lenient);

  /// Forgets the rows of vehicles, and calls `forget_vehicles`, when the first person comes. Without a call, they stay.
  void when_people_come(std::function<void()> forget_vehicles) { forget_vehicles_ = std::move(forget_vehicles); }
  bool is_row_at_fault() const { return is_row_at_fault_; }  ///< --lenient would skip the row
  std::size_t bad_rows() const { return bad_; }
  const std::string& first_bad_row() const { return first_bad_; }
  bool has_people() const { return has_people_; }
  bool has_z() const { return has_z_; }

 private:
  void open(const char* name, XmlAttributes attributes, std::size_t depth) override;
  void take_row(XmlAttributes attributes);
  bool take(XmlAttributes attributes, const char* name, double& number);
  /// A row, or the time of rows, is wrong.
  void refuse(const std::string& what);

  RowSink& sink_;
  bool is_lenient_;
  double time_ = 0.0;
  bool has_time_ = false, has_people_ = false, has_z_ = false, is_row_at_fault_ = false;
  std::string first_bad_;
  std::size_t bad_ = 0;
  std::function<void()> forget_vehicles_;
};

/// Reads all rows of a file. Errors begin with the file's name.
Status read_fcd_xml(const std::string& file, const TrackReading& options, const ReadProgress& progress,
                    RawTracks& tracks);

/// Returns what the rows of an FcdParser mean.
RowFacts fcd_facts();

}  // namespace throng
