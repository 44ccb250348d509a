#include "engine/tracks/fcd_xml.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

#include "engine/base/files/input_file.h"
#include "engine/base/text/plain_text.h"
#include "engine/tracks/progress_clock.h"
#include "engine/tracks/text/number_text.h"
#include "engine/tracks/text_rows.h"

namespace throng {
namespace {

constexpr std::size_t piece_bytes = std::size_t{256} << 10U;

}  // namespace

FcdParser::FcdParser(RowSink& sink, bool is_lenient)
    : XmlReader("let SUMO write it to its end, or take what is there with --lenient"),
      sink_(sink),
      is_lenient_(is_lenient) {}

void FcdParser::refuse(const std::string& what) {
  if (bad_++ == 0) first_bad_ = here() + what;
  if (is_lenient_) return;
  is_row_at_fault_ = true;
  stop(what);
}

bool FcdParser::take(XmlAttributes attributes, const char* name, double& number) {
  const char* const text = attributes.of(name);
  if (text != nullptr && is_number_text(text, number) && std::isfinite(number)) return true;
  const std::string seen = text == nullptr ? std::string("no ") + name : in_quotes(std::string(text).substr(0, 40));
  refuse(text == nullptr ? "it has " + seen + "; add it" : seen + " is not a number; put " + name + " there");
  return false;
}

void FcdParser::take_row(XmlAttributes attributes) {
  if (!has_time_) return;
  RawRow row{.time = time_};
  const char* const id = attributes.of("id");
  if (id == nullptr || *id == '\0') return refuse("it has no id; add one");
  if (!take(attributes, "x", row.x) || !take(attributes, "y", row.y)) return;
  double number = 0.0;
  if (attributes.of("z") != nullptr) {
    if (!take(attributes, "z", number)) return;
    row.z = static_cast<float>(number);
    has_z_ = true;
  }
  if (attributes.of("angle") != nullptr) {
    if (!take(attributes, "angle", number)) return;
    row.angle = static_cast<float>(number);
  }
  row.person = sink_.ids.number_of(id);
  if (!add_row(row, sink_)) refuse(sink_.fault);
  if (sink_.ids.size() > most_people) stop("more than 100,000 people");
}

void FcdParser::open(const char* name, XmlAttributes attributes, std::size_t depth) {
  if (depth == 0 && std::strcmp(name, "fcd-export") != 0) {
    return stop("<" + plain_text(std::string(name).substr(0, 40)) +
                "> is not what SUMO calls trajectories; name the file of --fcd-output");
  }
  const bool is_person = std::strcmp(name, "person") == 0;
  if (std::strcmp(name, "timestep") == 0) {
    has_time_ = take(attributes, "time", time_);
  } else if (is_person && !has_people_) {
    has_people_ = true;
    if (forget_vehicles_) {
      sink_.rows.clear();
      forget_vehicles_();
    }
    take_row(attributes);
  } else if (is_person || (!has_people_ && std::strcmp(name, "vehicle") == 0)) {
    take_row(attributes);
  }
}

RowFacts fcd_facts() {
  RowFacts facts;
  facts.format = "SUMO FCD";
  facts.angle = AngleMeaning::compass;
  return facts;
}

Status read_fcd_xml(const std::string& file, const TrackReading& options, const ReadProgress& progress,
                    RawTracks& tracks) {
  auto input = InputFile::open(file, "a file of trajectories");
  if (!input) return Error{file + ": " + input.error().message};
  RowSink sink;
  sink.most = most_metres / options.metres_a_unit.value_or(1.0);
  FcdParser parser(sink, options.lenient);
  parser.when_people_come([&] { tracks.blocks.clear(); });
  ProgressClock clock(progress);
  std::string piece(piece_bytes, '\0');
  std::vector<std::string> remarks;
  std::size_t done = 0;
  for (bool is_last = false; !is_last;) {
    const auto read = input->read(std::as_writable_bytes(std::span(piece)));
    if (!read) return Error{file + ": " + read.error().message};
    done += *read;
    is_last = *read < piece.size();
    const bool is_read = parser.read({piece.data(), *read}, is_last);
    if (!is_read && parser.ends_early() && options.lenient) {
      const std::string& fault = parser.fault();
      remarks.push_back("The file ends early, in " + fault.substr(0, fault.find(':')) +
                        "; its rows up to there are read.");
    } else if (!is_read) {
      if (sink.ids.size() > most_people) return too_many_people(file);
      return parser.is_row_at_fault() ? row_error(file, parser.fault()) : Error{file + ": " + parser.fault()};
    }
    if (!sink.rows.empty()) tracks.blocks.push_back({take_rows_of(sink), 0});
    clock.show(static_cast<double>(done) / static_cast<double>(std::max<std::uint64_t>(input->size(), 1)));
  }
  tracks.facts = fcd_facts();
  tracks.facts.format += parser.has_people() ? "" : " of vehicles";
  tracks.facts.has_z = parser.has_z();
  tracks.facts.remarks = std::move(remarks);
  tracks.tables.push_back(std::move(sink.ids));
  tracks.bad_rows = parser.bad_rows();
  tracks.first_bad_row = parser.first_bad_row();
  return Done{};
}

}  // namespace throng
