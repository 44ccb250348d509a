#include "engine/tracks/row_meaning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/base/text/joined.h"

namespace throng {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr std::size_t most_compared_steps = 50'000;

/// A step of a person from a row to the next.
struct SampledStep {
  double time, x, y;
  float angle;
};

/// Steps of the first people of the file.
std::vector<SampledStep> sample_steps(const RawTracks& tracks) {
  std::vector<const RawRow*> last(std::min<std::size_t>(tracks.tables.front().size(), 2000));
  std::vector<SampledStep> steps;
  for (const RowBlock& block : tracks.blocks) {
    for (const RawRow& row : block.rows) {
      if (row.person >= last.size()) continue;
      const RawRow* const before = std::exchange(last[row.person], &row);
      if (before == nullptr || before->time >= row.time) continue;
      steps.push_back({row.time - before->time, row.x - before->x, row.y - before->y, before->angle});
      if (steps.size() == most_compared_steps) return steps;
    }
  }
  return steps;
}

/// The value that a share of the values lie below; 0 of none.
double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

double step_time(const std::vector<SampledStep>& steps) {
  std::vector<double> times;
  times.reserve(steps.size());
  for (const SampledStep& step : steps) times.push_back(step.time);
  return percentile(std::move(times), 0.5);
}

/// Units that people go in a unit of time, at a percentile of all steps that move.
double pace(const std::vector<SampledStep>& steps, double share) {
  std::vector<double> paces;
  paces.reserve(steps.size());
  for (const SampledStep& step : steps) paces.push_back(std::hypot(step.x, step.y) / step.time);
  return percentile(std::move(paces), share);
}

/// A high percentile of z over the first rows: where z is of heads, it is how tall people are.
double high_z(const RawTracks& tracks, double share) {
  std::vector<double> heights;
  for (const RowBlock& block : tracks.blocks) {
    for (const RawRow& row : block.rows) {
      heights.push_back(static_cast<double>(row.z));
      if (heights.size() == most_compared_steps) return percentile(std::move(heights), share);
    }
  }
  return percentile(std::move(heights), share);
}

/// Tells metres from centimetres.
double guessed_unit(RawTracks& tracks, const std::vector<SampledStep>& steps) {
  RowFacts& facts = tracks.facts;
  const double tall = high_z(tracks, 0.5);
  if (facts.z_is_head && tall > 50.0 && tall < 300.0) {
    facts.remarks.push_back("Places are in centimetres: heads are " + fixed(tall, 0) + " high in the middle.");
    return 0.01;
  }
  if (facts.z_is_head && tall > 0.5 && tall < 3.0) {
    facts.remarks.push_back("Places are in metres: heads are " + fixed(tall, 2) + " high in the middle.");
    return 1.0;
  }
  const double fast = pace(steps, 0.95) * facts.rate.value_or(25.0);
  const bool is_centimetres = fast > 15.0;
  facts.remarks.push_back(
      is_centimetres
          ? "Places are in centimetres: in metres, people would go " + fixed(fast, 0) + " m/s; --unit overrules it."
          : "Places are taken as metres: people go up to " + fixed(fast, 1) + " m/s; --unit overrules it.");
  return is_centimetres ? 0.01 : 1.0;
}

double unit_of(RawTracks& tracks, const TrackReading& options, const std::vector<SampledStep>& steps) {
  if (options.metres_a_unit) return *options.metres_a_unit;
  if (tracks.facts.unit) return *tracks.facts.unit;
  return tracks.facts.tells_unit ? guessed_unit(tracks, steps) : 1.0;
}

/// Frames a second of a file that does not say it.
double guessed_rate(RawTracks& tracks, const std::vector<SampledStep>& steps, double metres_a_unit) {
  RowFacts& facts = tracks.facts;
  const double step = std::max(step_time(steps), 1e-9);
  if (facts.rate_rule == RateRule::annotated) {
    const double rows = tracks.scene_rate > 0.0 ? tracks.scene_rate : 2.5;
    facts.remarks.push_back(std::string(tracks.scene_rate > 0.0 ? "The file says" : "Such files have") + " a row of " +
                            "a person every " + fixed(1.0 / rows, 2) + " s, which is " + fixed(step, 0) +
                            " frames, so " + fixed(rows * step, 1) + " frames are a second; --fps overrules it.");
    return rows * step;
  }
  constexpr double usual = 25.0, other = 16.0, too_fast = 2.0;
  const double speed = pace(steps, 0.5) * metres_a_unit * usual;
  if (speed > too_fast) {
    facts.remarks.push_back("The file does not say its frame rate: 16 a second are taken, for people would go " +
                            fixed(speed, 1) + " m/s with 25; --fps overrules it.");
    return other;
  }
  facts.remarks.push_back("The file does not say its frame rate: 25 a second are taken, with which people go " +
                          fixed(speed, 1) + " m/s; --fps overrules it.");
  return usual;
}

double frames_a_second(RawTracks& tracks, const TrackReading& options, const std::vector<SampledStep>& steps,
                       double metres_a_unit) {
  if (options.fps) return *options.fps;
  if (tracks.facts.rate) {
    tracks.facts.remarks.push_back("The file says " + fixed(*tracks.facts.rate, 2) + " frames a second.");
    return *tracks.facts.rate;
  }
  return guessed_rate(tracks, steps, metres_a_unit);
}

/// Returns an angle of a file as radians counterclockwise from +x.
double as_radians(double angle, AngleMeaning meaning) {
  switch (meaning) {
    case AngleMeaning::degrees:
      return angle * degree;
    case AngleMeaning::compass:
      return std::numbers::pi / 2.0 - angle * degree;
    case AngleMeaning::heading:
      return angle - std::numbers::pi / 2.0;
    default:
      return angle;
  }
}

/// Returns how well angles agree with the ways that people go: 1 if they look ahead, 0 if they go sideways, -1 if they
/// look back. NaN if too few people go.
double agreement(const std::vector<SampledStep>& steps, AngleMeaning meaning, double least_pace) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const SampledStep& step : steps) {
    const double way = std::hypot(step.x, step.y);
    if (!std::isfinite(step.angle) || way / step.time < least_pace) continue;
    sum += std::cos(as_radians(static_cast<double>(step.angle), meaning) - std::atan2(step.y, step.x));
    ++count;
  }
  return count < 10 ? std::numeric_limits<double>::quiet_NaN() : sum / static_cast<double>(count);
}

/// With angles that agree by less, people would walk like crabs.
constexpr double least_agreement = 0.3, good_agreement = 0.7;

/// The largest angle of the file, without its sign.
double largest_angle(const RawTracks& tracks) {
  float largest = 0.0F;
  for (const RowBlock& block : tracks.blocks) {
    for (const RawRow& row : block.rows) {
      if (std::abs(row.angle) > largest) largest = std::abs(row.angle);  // false for NaN
    }
  }
  return static_cast<double>(largest);
}

Result<AngleMeaning> angle_told(RawTracks& tracks, const std::vector<SampledStep>& steps, double least_pace) {
  const double largest = largest_angle(tracks);
  std::vector<std::string>& remarks = tracks.facts.remarks;
  if (largest == 0.0) return AngleMeaning::degrees;
  const double degrees = agreement(steps, AngleMeaning::degrees, least_pace);
  if (agreement(steps, AngleMeaning::compass, least_pace) > good_agreement && degrees < least_agreement) {
    remarks.emplace_back(
        "Angles are degrees clockwise from north: so they agree with the ways that people go; --angle overrules it.");
    return AngleMeaning::compass;
  }
  if (largest > 2.0 * std::numbers::pi + 0.01) {
    remarks.push_back("Angles are in degrees: they go up to " + fixed(largest, 0) + ".");
    return AngleMeaning::degrees;
  }
  const double radians = agreement(steps, AngleMeaning::radians, least_pace);
  if (std::isnan(radians) || std::abs(radians - degrees) < 0.2) {
    return Error{"its angles go up to " + fixed(largest, 2) +
                 ", which may be degrees or radians; say which with --angle degrees or --angle radians"};
  }
  const bool is_radians = radians > degrees;
  remarks.push_back(std::string("Angles are in ") + (is_radians ? "radians" : "degrees") +
                    ": so they agree with the ways that people go.");
  return is_radians ? AngleMeaning::radians : AngleMeaning::degrees;
}

/// Doubts angles of people who do not go where they look, and names the option with which they do.
void doubt_angles(RawTracks& tracks, const std::vector<SampledStep>& steps, AngleMeaning meaning, double least_pace) {
  const double agreed = agreement(steps, meaning, least_pace);
  if (!(agreed < least_agreement)) return;  // NaN of too few steps is no doubt
  std::string remedy = "--angle none has people look where they go";
  for (const auto& [other, option] :
       {std::pair(AngleMeaning::compass, "north"), std::pair(AngleMeaning::degrees, "degrees"),
        std::pair(AngleMeaning::radians, "radians")}) {
    const bool is_better = meaning != AngleMeaning::heading && agreement(steps, other, least_pace) > good_agreement;
    if (is_better) remedy = std::string("with --angle ") + option + " they do";
  }
  tracks.facts.remarks.push_back("People do not go where their angles point, which agree by " + fixed(agreed, 2) +
                                 " on the average: " + remedy + ".");
}

Result<AngleMeaning> angle_of(RawTracks& tracks, const TrackReading& options, const std::vector<SampledStep>& steps,
                              double least_pace) {
  AngleMeaning meaning = angle_asked(tracks.facts.angle, options.angle);
  if (meaning == AngleMeaning::none) return meaning;
  if (meaning == AngleMeaning::unknown) {
    auto told = angle_told(tracks, steps, least_pace);
    if (!told) return told;
    meaning = *told;
  }
  doubt_angles(tracks, steps, meaning, least_pace);
  return meaning;
}

bool z_is_head(RawTracks& tracks, const TrackReading& options, double metres_a_unit) {
  const bool is_asked = options.height == TrackHeight::ground || options.height == TrackHeight::none;
  if (!tracks.facts.has_z || is_asked) return false;
  const double high = high_z(tracks, 0.95) * metres_a_unit, low = high_z(tracks, 0.05) * metres_a_unit;
  std::vector<std::string>& remarks = tracks.facts.remarks;
  const bool could_be = low > 0.9 && high < 2.3;
  if (options.height == TrackHeight::head) return true;
  if (!tracks.facts.z_is_head) {
    if (could_be) {
      remarks.push_back("z is taken as the ground, but it lies between " + fixed(low, 2) + " and " + fixed(high, 2) +
                        " m, as heads do; --height head takes it so.");
    }
    return false;
  }
  const bool is_head = high > 0.5 && high < 2.5;
  if (is_head) {
    remarks.push_back("z is the height of heads: 95 of 100 rows are below " + fixed(high, 2) + " m.");
  } else {
    remarks.push_back("z cannot be the height of heads, for 95 of 100 rows are below " + fixed(high, 2) +
                      " m; it is taken as the ground.");
  }
  return is_head;
}

}  // namespace

AngleMeaning angle_asked(AngleMeaning of_file, TrackAngle asked) {
  if (of_file == AngleMeaning::none || asked == TrackAngle::none) return AngleMeaning::none;
  if (of_file == AngleMeaning::heading || asked == TrackAngle::guessed) return of_file;
  if (asked == TrackAngle::radians) return AngleMeaning::radians;
  const bool is_compass = asked == TrackAngle::north || of_file == AngleMeaning::compass;  // a compass has degrees
  return is_compass ? AngleMeaning::compass : AngleMeaning::degrees;
}

double times_a_second(const RowFacts& facts, const TrackReading& options) {
  return options.times_a_second.value_or(facts.times_a_second);
}

Result<RowScale> tell_apart(RawTracks& tracks, const TrackReading& options) {
  const std::vector<SampledStep> steps = sample_steps(tracks);
  RowScale scale;
  scale.metres_a_unit = unit_of(tracks, options, steps);
  scale.times_a_second = tracks.facts.has_frames ? frames_a_second(tracks, options, steps, scale.metres_a_unit)
                                                 : times_a_second(tracks.facts, options);
  if (tracks.facts.has_frames && options.times_a_second) {
    tracks.facts.remarks.emplace_back("--time-unit is not used, for the rows have frames: --fps gives their rate.");
  }
  if (!tracks.facts.has_frames && options.fps) {
    tracks.facts.remarks.emplace_back("--fps is not used, for the rows have times: --time-unit gives their unit.");
  }
  constexpr double least_speed = 0.3;  // metres a second: slower people look anywhere
  const auto angle = angle_of(tracks, options, steps, least_speed / (scale.times_a_second * scale.metres_a_unit));
  if (!angle) return angle.error();
  scale.angle = *angle;
  scale.z_is_head = z_is_head(tracks, options, scale.metres_a_unit);
  scale.has_heights = options.height != TrackHeight::none;
  return scale;
}

}  // namespace throng
