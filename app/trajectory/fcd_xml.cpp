#include "app/trajectory/fcd_xml.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <new>
#include <span>
#include <utility>
#include <vector>

#include <expat.h>

#include "app/trajectory/number_text.h"
#include "app/trajectory/progress_clock.h"
#include "app/trajectory/text_format.h"
#include "app/trajectory/text_rows.h"
#include "engine/anim/base/plain_text.h"
#include "engine/files/input_file.h"

namespace throng::app {
namespace {

constexpr std::size_t piece_bytes = std::size_t{256} << 10U;

const char* value_of(const XML_Char** attributes, std::string_view name) {
  for (; *attributes != nullptr; attributes += 2) {
    if (name == attributes[0]) return attributes[1];
  }
  return nullptr;
}

}  // namespace

struct FcdParser::State {
  RowSink* sink = nullptr;
  bool is_lenient = false;
  XML_Parser parser = nullptr;
  std::size_t depth = 0;
  double time = 0.0;
  bool has_time = false, has_people = false, has_z = false, is_row_at_fault = false;
  std::string fault = {}, first_bad = {};
  std::size_t bad = 0;

  std::string here() const { return "line " + std::to_string(XML_GetCurrentLineNumber(parser)) + ": "; }

  void stop(std::string what) {
    if (!fault.empty()) return;
    fault = here() + std::move(what);
    XML_StopParser(parser, XML_FALSE);
  }

  /// A row, or the time of rows, is wrong.
  void refuse(std::string what) {
    if (bad++ == 0) first_bad = here() + what;
    if (is_lenient) return;
    is_row_at_fault = true;
    stop(std::move(what));
  }

  bool take(const XML_Char** attributes, const char* name, double& number) {
    const char* const text = value_of(attributes, name);
    if (text != nullptr && is_number_text(text, number) && std::isfinite(number)) return true;
    const std::string seen =
        text == nullptr ? std::string("no ") + name : anim::in_quotes(std::string(text).substr(0, 40));
    refuse(text == nullptr ? "it has " + seen + "; add it" : seen + " is not a number; put " + name + " there");
    return false;
  }

  void take_row(const XML_Char** attributes) {
    if (!has_time) return;
    RawRow row{.time = time};
    const char* const id = value_of(attributes, "id");
    if (id == nullptr || *id == '\0') return refuse("it has no id; add one");
    if (!take(attributes, "x", row.x) || !take(attributes, "y", row.y)) return;
    double number = 0.0;
    if (value_of(attributes, "z") != nullptr) {
      if (!take(attributes, "z", number)) return;
      row.z = static_cast<float>(number);
      has_z = true;
    }
    if (value_of(attributes, "angle") != nullptr) {
      if (!take(attributes, "angle", number)) return;
      row.angle = static_cast<float>(number);
    }
    row.person = sink->ids.number_of(id);
    if (!add_row(row, *sink)) refuse(sink->fault);
    if (sink->ids.size() > most_people) stop("more than 100,000 people");
  }

  void open(const char* name, const XML_Char** attributes) {
    if (depth++ == 0 && std::strcmp(name, "fcd-export") != 0) {
      return stop("<" + std::string(name).substr(0, 40) +
                  "> is not what SUMO calls trajectories; name the file of --fcd-output");
    }
    const bool is_person = std::strcmp(name, "person") == 0;
    if (std::strcmp(name, "timestep") == 0) {
      has_time = take(attributes, "time", time);
    } else if (is_person && !has_people) {
      has_people = true;
      if (forget_vehicles) {
        sink->rows.clear();
        forget_vehicles();
      }
      take_row(attributes);
    } else if (is_person || (!has_people && std::strcmp(name, "vehicle") == 0)) {
      take_row(attributes);
    }
  }

  std::function<void()> forget_vehicles;

  static void at_start(void* context, const XML_Char* name, const XML_Char** attributes) {
    static_cast<State*>(context)->open(name, attributes);
  }
  /// A document of SUMO has none, and entities could grow without end.
  static void at_doctype(void* context, const XML_Char* /*name*/, const XML_Char* /*system*/, const XML_Char* /*place*/,
                         int /*has_subset*/) {
    static_cast<State*>(context)->stop("it has a DOCTYPE, which is not read; take it out");
  }
  static void at_end(void* context, const XML_Char* /*name*/) { --static_cast<State*>(context)->depth; }
};

FcdParser::FcdParser(RowSink& sink, bool is_lenient) : state_(std::make_unique<State>()) {
  state_->sink = &sink;
  state_->is_lenient = is_lenient;
  state_->parser = XML_ParserCreate(nullptr);
  if (state_->parser == nullptr) throw std::bad_alloc();
  XML_SetUserData(state_->parser, state_.get());
  XML_SetStartDoctypeDeclHandler(state_->parser, State::at_doctype);
  XML_SetElementHandler(state_->parser, State::at_start, State::at_end);
}

FcdParser::~FcdParser() { XML_ParserFree(state_->parser); }

bool FcdParser::read(std::string_view text, bool is_last) {
  if (!state_->fault.empty()) return false;
  const XML_Status status = XML_Parse(state_->parser, text.data(), static_cast<int>(text.size()), is_last ? 1 : 0);
  if (status == XML_STATUS_OK && state_->fault.empty()) return true;
  if (state_->fault.empty()) {
    state_->fault = state_->here() + "it is no whole XML (" + XML_ErrorString(XML_GetErrorCode(state_->parser)) +
                    "); let SUMO write it to its end";
  }
  return false;
}

const std::string& FcdParser::fault() const { return state_->fault; }
bool FcdParser::is_row_at_fault() const { return state_->is_row_at_fault; }
std::size_t FcdParser::bad_rows() const { return state_->bad; }
const std::string& FcdParser::first_bad_row() const { return state_->first_bad; }
bool FcdParser::has_people() const { return state_->has_people; }
bool FcdParser::has_z() const { return state_->has_z; }
void FcdParser::when_people_come(std::function<void()> forget_vehicles) {
  state_->forget_vehicles = std::move(forget_vehicles);
}

bool is_xml(std::string_view head) {
  head.remove_prefix(byte_order_mark(head));
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && head[first] == '<';
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
  std::size_t done = 0;
  for (bool is_last = false; !is_last;) {
    const auto read = input->read(std::as_writable_bytes(std::span(piece)));
    if (!read) return Error{file + ": " + read.error().message};
    done += *read;
    is_last = *read < piece.size();
    if (!parser.read({piece.data(), *read}, is_last)) {
      if (sink.ids.size() > most_people) return too_many_people(file);
      return parser.is_row_at_fault() ? row_error(file, parser.fault(), "") : Error{file + ": " + parser.fault()};
    }
    if (!sink.rows.empty()) tracks.blocks.push_back({take_rows_of(sink), 0});
    clock.tell(static_cast<double>(done) / static_cast<double>(std::max<std::uint64_t>(input->size(), 1)));
  }
  tracks.facts = fcd_facts();
  tracks.facts.format += parser.has_people() ? "" : " of vehicles";
  tracks.facts.has_z = parser.has_z();
  tracks.tables.push_back(std::move(sink.ids));
  tracks.bad_rows = parser.bad_rows();
  tracks.first_bad_row = parser.first_bad_row();
  return Done{};
}

}  // namespace throng::app
