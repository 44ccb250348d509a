#include "engine/tracks/ndjson.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "engine/base/text/plain_text.h"
#include "engine/tracks/text/known_keys.h"
#include "engine/tracks/text/number_text.h"
#include "engine/tracks/text/table_layout.h"

namespace throng {
namespace {

/// Goes through the text of an object. Strings keep their escapes: no key that is looked for has one.
class JsonScanner {
 public:
  explicit JsonScanner(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

  bool takes(char wanted) {
    skip_blanks();
    if (at_ == end_ || *at_ != wanted) return false;
    ++at_;
    return true;
  }
  bool is_at(char wanted) {
    skip_blanks();
    return at_ < end_ && *at_ == wanted;
  }
  bool is_at_end() {
    skip_blanks();
    return at_ == end_;
  }
  /// Takes a string, without its quotes.
  bool take_string(std::string_view& text) {
    if (!takes('"')) return false;
    const char* const first = at_;
    for (; at_ < end_ && *at_ != '"'; ++at_) {
      if (*at_ == '\\' && at_ + 1 < end_) ++at_;
    }
    if (at_ == end_) return false;
    text = {first, static_cast<std::size_t>(at_ - first)};
    ++at_;
    return true;
  }
  /// Takes a value that is no object and no list: its text, without quotes.
  bool take_plain(std::string_view& text) {
    if (is_at('"')) return take_string(text);
    const char* const first = at_;
    while (at_ < end_ && *at_ != ',' && *at_ != '}' && *at_ != ']' && *at_ != ' ') ++at_;
    text = {first, static_cast<std::size_t>(at_ - first)};
    return !text.empty();
  }
  /// Takes any value.
  bool skip_value() {
    std::size_t depth = 0;
    std::string_view ignored;
    do {
      skip_blanks();
      if (at_ == end_) return false;
      if (*at_ == '"') {
        if (!take_string(ignored)) return false;
        continue;
      }
      if (*at_ == '{' || *at_ == '[') ++depth;
      if ((*at_ == '}' || *at_ == ']') && depth-- == 0) return false;
      ++at_;
    } while (depth > 0 || (at_ < end_ && *at_ != ',' && *at_ != '}' && *at_ != ']'));
    return true;
  }

 private:
  void skip_blanks() {
    while (at_ < end_ && (*at_ == ' ' || *at_ == '\t' || *at_ == '\r')) ++at_;
  }

  const char* at_;
  const char* end_;
};

/// Calls visit(key) for each member of an object, which takes its value. Returns false if it is no object.
template <typename Visit>
bool for_members(JsonScanner& scanner, Visit visit) {
  if (!scanner.takes('{')) return false;
  if (scanner.takes('}')) return true;
  std::string_view key;
  do {
    if (!scanner.take_string(key) || !scanner.takes(':') || !visit(key)) return false;
  } while (scanner.takes(','));
  return scanner.takes('}');
}

/// The values of a line, by field.
struct FoundValues {
  std::array<std::string_view, track_field_count> texts;
  FieldRanks ranks;

  std::string_view operator[](TrackField field) const { return texts[static_cast<std::size_t>(field)]; }
};

class NdjsonParser final : public LineParser {
 public:
  std::unique_ptr<LineParser> copy() const override { return std::make_unique<NdjsonParser>(*this); }

  bool read(std::string_view line, RowSink& sink) override {
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) return true;
    JsonScanner scanner(line);
    FoundValues found;
    bool is_prediction = false, is_scene = false;
    const bool is_object = for_members(scanner, [&](std::string_view key) {
      if (key == "track")
        return for_members(scanner, [&](auto inner) { return take(scanner, inner, found, is_prediction); });
      if (key != "scene") return take(scanner, key, found, is_prediction);
      is_scene = true;
      return for_members(scanner, [&](std::string_view inner) { return take_scene(scanner, inner, sink); });
    });
    if (!is_object || !scanner.is_at_end()) {
      sink.fault =
          "it is no JSON object; put one there, such as {\"track\": {\"f\": 10, \"p\": 7, \"x\": 1.5, \"y\": 2}}";
      return false;
    }
    return is_scene || is_prediction || add(found, sink);
  }

  TrackField time() const { return time_; }
  void set_time(TrackField time) { time_ = time; }
  bool has(TrackField field) const { return (seen_ >> static_cast<unsigned>(field) & 1U) != 0; }

 private:
  bool take(JsonScanner& scanner, std::string_view key, FoundValues& found, bool& is_prediction) {
    if (key == "prediction_number") {
      std::string_view value;
      if (!scanner.take_plain(value)) return false;
      is_prediction = value != "null";
      return true;
    }
    const bool is_plain = !scanner.is_at('{') && !scanner.is_at('[');
    const KnownKeys::Key& known = keys_.of(key);
    if (!is_plain || !found.ranks.takes(known)) return scanner.skip_value();
    const auto field = static_cast<std::size_t>(known.column.field);
    seen_ |= 1U << field;
    return scanner.take_plain(found.texts[field]);
  }

  static bool take_scene(JsonScanner& scanner, std::string_view key, RowSink& sink) {
    std::string_view text;
    if (key != "fps") return scanner.skip_value();
    if (scanner.is_at('{') || scanner.is_at('[') || !scanner.take_plain(text)) return false;
    double rate = 0.0;
    if (is_number_text(text, rate) && rate > 0.0 && rate <= 10'000.0) sink.scene_rate = rate;
    return true;
  }

  bool add(const FoundValues& found, RowSink& sink) const {
    const auto number_of = [&](TrackField field, double& value) {
      const std::string_view text = found[field];
      if (is_number_text(text, value) && std::isfinite(value)) return true;
      const std::string name = field == TrackField::x ? "x" : field == TrackField::y ? "y" : "time or frame";
      sink.fault = text.empty() ? "it has no " + name + "; add it"
                                : in_quotes(text.substr(0, 40)) + " is not a number; put " + name + " there";
      return false;
    };
    RawRow row;
    if (found[TrackField::id].empty()) {
      sink.fault = "it has no id of a person; add \"p\" or \"id\"";
      return false;
    }
    if (!number_of(time_, row.time) || !number_of(TrackField::x, row.x) || !number_of(TrackField::y, row.y))
      return false;
    double value = 0.0;
    if (!found[TrackField::z].empty()) {
      if (!number_of(TrackField::z, value)) return false;
      row.z = static_cast<float>(value);
    }
    if (!found[TrackField::angle].empty()) {
      if (!number_of(TrackField::angle, value)) return false;
      row.angle = static_cast<float>(value);
    }
    std::array<char, 32> digits;
    row.person = sink.ids.number_of(plain_id(found[TrackField::id], digits));
    return add_row(row, sink);
  }

  KnownKeys keys_;
  unsigned seen_ = 0;
  TrackField time_ = TrackField::frame;
};

}  // namespace

Result<TextFormat> ndjson_format(std::string_view first) {
  if (first.find('}') == std::string_view::npos || first.find('[') < first.find('{')) {
    return Error{"it is one document of JSON; put the object of a row on each line, or export CSV"};
  }
  auto parser = std::make_unique<NdjsonParser>();
  RowSink sink;
  TextFormat format;
  static_cast<void>(parser->read(first, sink));  // which keys are there
  if (parser->has(TrackField::time)) parser->set_time(TrackField::time);
  if (!parser->read(first, sink)) return Error{sink.fault};
  const bool is_trajnet =
      first.find("\"track\"") != std::string_view::npos || first.find("\"scene\"") != std::string_view::npos;
  format.facts.format = is_trajnet ? "trajnet ndjson" : "JSON lines";
  format.facts.has_frames = parser->time() == TrackField::frame;
  format.facts.rate_rule = is_trajnet ? RateRule::annotated : RateRule::by_speed;
  format.facts.has_z = parser->has(TrackField::z);
  if (parser->has(TrackField::angle)) format.facts.angle = AngleMeaning::unknown;
  format.parser = std::move(parser);
  return format;
}

}  // namespace throng
