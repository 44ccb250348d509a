#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "engine/tracks/raw_rows.h"
#include "engine/tracks/reading.h"

namespace throng {

/// Reads the XML that SUMO writes (FCD), piece by piece: the people, and the vehicles where there are no people.
class FcdParser {
 public:
  /// Rows go to `sink`, which outlives the parser.
  FcdParser(RowSink& sink, bool is_lenient);
  ~FcdParser();
  FcdParser(const FcdParser&) = delete;
  FcdParser& operator=(const FcdParser&) = delete;

  /// Forgets the rows of vehicles, and calls `forget_vehicles`, when the first person comes. Without a call, they stay.
  void when_people_come(std::function<void()> forget_vehicles);
  /// Reads the next piece. Returns false after the first error. `is_last` ends the document.
  bool read(std::string_view text, bool is_last);
  /// The end of a sentence, "line 7: ...".
  const std::string& fault() const;
  bool ends_early() const;
  bool is_row_at_fault() const;  ///< --lenient would skip the row
  std::size_t bad_rows() const;
  const std::string& first_bad_row() const;
  bool has_people() const;
  bool has_z() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Reads all rows of a file. Errors begin with the file's name.
Status read_fcd_xml(const std::string& file, const TrackReading& options, const ReadProgress& progress,
                    RawTracks& tracks);

/// Returns what the rows of an FcdParser mean.
RowFacts fcd_facts();

}  // namespace throng
