#include "engine/tracks/live/live_tracks.h"

#include <array>
#include <cmath>
#include <condition_variable>
#include <cstring>
#include <limits>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "engine/base/files/waiting_input.h"
#include "engine/base/text/joined.h"
#include "engine/tracks/fcd_xml.h"
#include "engine/tracks/row_meaning.h"
#include "engine/tracks/sqlite_file.h"
#include "engine/tracks/text/xml_text.h"
#include "engine/tracks/text_format.h"
#include "engine/tracks/text_rows.h"
#include "engine/tracks/tracks.h"

namespace throng {
namespace {

constexpr std::size_t most_waiting = std::size_t{4} << 20U;  // bytes of a line, or before the first row

/// Returns what rows mean before people have moved, when their ways show nothing yet.
RowScale scale_at_once(RowFacts& facts, const TrackReading& options, const RawRow& first) {
  RowScale scale;
  const bool is_tall = facts.tells_unit && facts.z_is_head && first.z > 50.0F && first.z < 300.0F;
  scale.metres_a_unit = options.metres_a_unit.value_or(facts.unit.value_or(is_tall ? 0.01 : 1.0));
  if (is_tall && !facts.unit) facts.remarks.emplace_back("Places are in centimetres, for heads are so high.");
  scale.times_a_second = times_a_second(facts, options);
  if (facts.has_frames) {
    scale.times_a_second = options.fps.value_or(facts.rate.value_or(25.0));
    if (!options.fps && !facts.rate) {
      facts.remarks.emplace_back("The rows do not say their frame rate: 25 a second are taken; --fps overrules it.");
    }
  }
  scale.angle = angle_asked(facts.angle, options.angle);
  if (scale.angle == AngleMeaning::unknown) {
    scale.angle = AngleMeaning::degrees;
    facts.remarks.emplace_back("Angles are taken as degrees; --angle radians overrules it.");
  }
  scale.z_is_head =
      options.height == TrackHeight::head || (options.height == TrackHeight::by_format && facts.z_is_head);
  scale.has_heights = options.height != TrackHeight::none;
  return scale;
}

/// Steps of Vadere end where the next one begins, so that every moment is there twice.
bool is_same_moment(const TrackRow& a, const TrackRow& b) {
  constexpr float same_place = 1e-3F;  // metres
  return a.seconds == b.seconds && std::hypot(a.x - b.x, a.z - b.z) < same_place;
}

}  // namespace

struct LiveTracks::State {
  explicit State(int descriptor) : input(descriptor) {}

  // The thread's own.
  WaitingInput input;  // when it is stopped, the thread ends
  TrackReading options;
  std::string name;
  std::string text;  // not read yet
  std::size_t line = 1;
  RowSink sink;
  RowFacts facts;
  RowScale scale;
  std::unique_ptr<LineParser> lines;
  std::unique_ptr<FcdParser> xml;
  std::vector<TrackRow> last_rows;  // of people
  std::size_t told_people = 0;
  std::thread thread;

  // Both threads see these.
  mutable std::mutex mutex;
  std::condition_variable came, was_taken;
  bool is_to_stop = false;
  std::vector<LiveRow> rows;
  std::vector<std::string> ids;
  std::optional<LiveHead> live_head;
  Status status = Done{};
  bool has_ended = false;
  std::size_t bad = 0, late = 0;

  /// Returns a value that both threads see.
  template <typename Value>
  Value seen(Value State::*value) const {
    const std::lock_guard lock(mutex);
    return this->*value;
  }

  void run();
  bool read_more();
  bool take_text(bool is_last);
  bool choose_format(bool is_last);
  bool take_lines(bool is_last);
  bool take_xml(bool is_last);
  void begin();
  void hand_over();
  bool fail(std::string what);
};

bool LiveTracks::State::fail(std::string what) {
  const std::lock_guard lock(mutex);
  status = Error{name + ": " + std::move(what)};
  return false;
}

void LiveTracks::State::run() {
  while (read_more()) {
  }
  const std::lock_guard lock(mutex);
  has_ended = true;
  came.notify_all();
}

/// Waits for text and reads it. Returns false at the end.
bool LiveTracks::State::read_more() {
  std::array<char, 65536> piece;
  const auto count = input.read(piece);
  if (!count) return fail(count.error().message);
  if (!*count) return false;
  text.append(piece.data(), **count);
  const bool goes_on = take_text(**count == 0) && **count > 0;
  hand_over();
  return goes_on;
}

bool LiveTracks::State::take_text(bool is_last) {
  if (lines == nullptr && xml == nullptr && !choose_format(is_last)) return false;
  if (lines != nullptr) return take_lines(is_last);
  if (xml != nullptr) return take_xml(is_last);
  if (text.size() > most_waiting) return fail("4 MiB came without a row; send rows with a newline after each");
  return true;
}

/// Finds the format of the text as soon as its first row is there.
bool LiveTracks::State::choose_format(bool is_last) {
  if (is_sqlite(text)) return fail("a database cannot be read as it comes; give its file's name instead of -");
  if (is_xml(text)) {
    xml = std::make_unique<FcdParser>(sink, options.lenient);
    facts = fcd_facts();
    return true;
  }
  const std::size_t newline = text.rfind('\n');
  const std::string_view whole = is_last ? std::string_view(text) : std::string_view(text).substr(0, newline + 1);
  if (const std::string why = why_no_text(text); !why.empty()) return fail(why);
  if (!is_last && (newline == std::string::npos || !has_first_row(whole))) return true;
  auto format = text_format_of(whole);
  if (!format) return fail(format.error().message);
  lines = std::move(format->parser);
  facts = std::move(format->facts);
  line = format->body_line;
  text.erase(0, format->body);
  return true;
}

bool LiveTracks::State::take_lines(bool is_last) {
  sink.most = most_metres / options.metres_a_unit.value_or(facts.unit.value_or(1.0));
  std::size_t at = 0;
  for (;; ++line) {
    const std::size_t newline = text.find('\n', at);
    if (newline == std::string::npos && (!is_last || at >= text.size())) break;
    const std::size_t end = std::min(newline, text.size());
    const std::size_t before = sink.rows.size();
    if (!lines->read(std::string_view(text).substr(at, end - at), sink)) {
      sink.rows.resize(before);
      if (!options.lenient) {
        return fail("line " + std::to_string(line) + ": " + sink.fault + ", or skip such rows with --lenient");
      }
      const std::lock_guard lock(mutex);
      ++bad;
    }
    if (sink.ids.size() > most_people) return fail("it has more than 100,000 people; send fewer");
    at = end + 1;
  }
  text.erase(0, std::min(at, text.size()));
  return text.size() <= most_waiting || fail("line " + std::to_string(line) + ": it is longer than 4 MiB");
}

bool LiveTracks::State::take_xml(bool is_last) {
  const bool is_read = xml->read(text, is_last);
  text.clear();
  const std::lock_guard lock(mutex);
  bad = xml->bad_rows();
  if (is_read) return true;
  status = Error{name + ": " + xml->fault() + (xml->is_row_at_fault() ? ", or skip such rows with --lenient" : "")};
  return false;
}

/// Settles what rows mean, when the first row is there.
void LiveTracks::State::begin() {
  const RawRow& first = sink.rows.front();
  scale = scale_at_once(facts, options, first);
  live_head = LiveHead{.origin = {std::round(first.x * scale.metres_a_unit), std::round(first.y * scale.metres_a_unit)},
                       .reading = options,
                       .format = facts.format,
                       .remarks = facts.remarks};
}

/// Gives the rows that were read to the thread that takes them.
void LiveTracks::State::hand_over() {
  if (sink.rows.empty()) return;
  std::unique_lock lock(mutex);
  was_taken.wait(lock, [this] { return rows.size() < most_waiting_rows || is_to_stop; });
  if (!live_head) begin();
  for (; told_people < sink.ids.size(); ++told_people)
    ids.push_back(sink.ids.id(static_cast<std::uint32_t>(told_people)));
  last_rows.resize(ids.size(), TrackRow{.seconds = -std::numeric_limits<double>::infinity()});
  for (RawRow& raw : sink.rows) {
    if (options.up == TrackUp::y) swap_up(raw);
    LiveRow& live = rows.emplace_back();
    live.person = raw.person;
    live.row = track_row(raw, scale, live_head->origin);
    if (scale.angle != AngleMeaning::heading) live.row.heading = heading_of_angle(raw.angle, scale.angle);
    if (scale.z_is_head) live.stature = std::exchange(live.row.y, 0.0F);
    TrackRow& last = last_rows[raw.person];
    if (live.row.seconds > last.seconds) {
      last = live.row;
    } else {
      late += is_same_moment(live.row, last) ? 0U : 1U;
      rows.pop_back();
    }
  }
  sink.rows.clear();
  came.notify_all();
}

LiveTracks::LiveTracks(int descriptor, const TrackReading& options, std::string name)
    : state_(std::make_unique<State>(descriptor)) {
  State& state = *state_;
  state.options = options;
  state.name = std::move(name);
  if (const Status opened = state.input.open(); !opened) {
    state.status = Error{state.name + ": " + opened.error().message};
    state.has_ended = true;
    return;
  }
  try {
    state.thread = std::thread([&state] { state.run(); });
  } catch (const std::system_error& error) {
    state.status = Error{state.name + ": no thread can be started to read it: " + error.what()};
    state.has_ended = true;
  }
}

LiveTracks::~LiveTracks() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->is_to_stop = true;
    state_->was_taken.notify_all();
  }
  state_->input.stop();
  if (state_->thread.joinable()) state_->thread.join();
}

bool LiveTracks::take(std::vector<LiveRow>& rows) {
  const std::lock_guard lock(state_->mutex);
  rows.insert(rows.end(), state_->rows.begin(), state_->rows.end());
  state_->rows.clear();
  state_->was_taken.notify_all();
  return !state_->has_ended;
}

void LiveTracks::wait(std::chrono::milliseconds most) const {
  std::unique_lock lock(state_->mutex);
  state_->came.wait_for(lock, most, [this] { return !state_->rows.empty() || state_->has_ended; });
}

std::string LiveTracks::id(std::uint32_t person) const {
  const std::lock_guard lock(state_->mutex);
  return state_->ids[person];
}

bool LiveTracks::has_ended() const { return state_->seen(&State::has_ended); }
std::optional<LiveHead> LiveTracks::head() const { return state_->seen(&State::live_head); }
Status LiveTracks::status() const { return state_->seen(&State::status); }
std::size_t LiveTracks::bad_rows() const { return state_->seen(&State::bad); }
std::size_t LiveTracks::late_rows() const { return state_->seen(&State::late); }

}  // namespace throng
