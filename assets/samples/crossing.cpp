// A crowd that two corridors lead across each other. Each person goes straight on, and slows down or gives way where
// it would meet another within two seconds. Only sums, products and square roots are computed, so that every machine
// writes the same digits.
#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "assets/samples/samples.h"
#include "engine/base/random.h"
#include "engine/base/text/joined.h"

namespace throng::samples {
namespace {

using glm::dvec2;

constexpr double half_length = 8.0, half_width = 2.0;  // of a corridor, metres
constexpr int people_a_stream = 12, rows_a_second = 10, steps_a_row = 2, most_rows = 400;
constexpr double step = 1.0 / (rows_a_second * steps_a_row);  // seconds

struct Walker {
  double begins;  ///< seconds
  dvec2 place, ahead;
  double speed;   ///< metres a second that it likes to go
  double height;  ///< metres, of its head
  dvec2 velocity = ahead * speed;
  std::vector<std::string> rows = {};

  [[nodiscard]] bool is_there(double seconds) const {
    return seconds >= begins && glm::dot(place, ahead) < half_length;
  }
};

std::vector<Walker> make_walkers() {
  constexpr double pause = 0.6, lane = 0.75;
  Random random(1, 1);
  std::vector<Walker> walkers;
  for (int i = 0; i < 2 * people_a_stream; ++i) {
    const dvec2 ahead = i % 2 == 0 ? dvec2(1, 0) : dvec2(0, 1);
    const dvec2 aside(ahead.y, ahead.x);
    const double lane_offset = lane * (i / 2 * 2 % 5 - 2) + static_cast<double>(random.between(-0.1F, 0.1F));
    walkers.push_back({.begins = pause * (i / 2),
                       .place = aside * lane_offset - ahead * half_length,
                       .ahead = ahead,
                       .speed = static_cast<double>(random.between(1.15F, 1.55F)),
                       .height = static_cast<double>(random.between(1.56F, 1.90F))});
  }
  return walkers;
}

/// Returns the acceleration away from where two people would be nearest to each other within the next two seconds.
dvec2 away_from(const Walker& other, const Walker& walker) {
  constexpr double foresight = 2.0, room = 0.8, strength = 4.0;
  const dvec2 between = walker.place - other.place, towards = walker.velocity - other.velocity;
  const double closing = glm::dot(towards, towards);
  const double seconds = closing > 0 ? std::clamp(-glm::dot(between, towards) / closing, 0.0, foresight) : 0.0;
  const dvec2 nearest = between + towards * seconds;
  const double distance = std::max(glm::length(nearest), 1e-3);
  if (distance >= room) return dvec2(0);
  return nearest / distance * (strength * (room - distance) / room / (0.3 + seconds));
}

dvec2 acceleration(const std::vector<Walker>& walkers, const Walker& walker, double seconds) {
  constexpr double relaxation = 0.5, from_wall = 0.4, wall_strength = 8.0;
  dvec2 sum = (walker.ahead * walker.speed - walker.velocity) / relaxation;
  for (const Walker& other : walkers) {
    if (&other != &walker && other.is_there(seconds)) sum += away_from(other, walker);
  }
  const dvec2 aside(walker.ahead.y, walker.ahead.x);
  const double off = glm::dot(walker.place, aside);
  const double over = std::max(std::abs(off) - (half_width - from_wall), 0.0);
  return sum - aside * std::copysign(wall_strength * over, off);
}

void go_on(std::vector<Walker>& walkers, double seconds) {
  std::vector<dvec2> pushes;
  for (const Walker& walker : walkers) pushes.push_back(acceleration(walkers, walker, seconds));
  for (std::size_t i = 0; i < walkers.size(); ++i) {
    if (!walkers[i].is_there(seconds)) continue;
    walkers[i].velocity += pushes[i] * step;
    walkers[i].place += walkers[i].velocity * step;
  }
}

}  // namespace

std::string make_crossing() {
  std::vector<Walker> walkers = make_walkers();
  for (int row = 0; row < most_rows; ++row) {
    for (std::size_t i = 0; i < walkers.size(); ++i) {
      Walker& walker = walkers[i];
      if (!walker.is_there(static_cast<double>(row) / rows_a_second)) continue;
      walker.rows.push_back(std::to_string(i + 1) + ' ' + std::to_string(row) + ' ' + fixed(walker.place.x, 3) + ' ' +
                            fixed(walker.place.y, 3) + ' ' + fixed(walker.height, 3) + '\n');
    }
    for (int part = 0; part < steps_a_row; ++part) {
      go_on(walkers, static_cast<double>(row) / rows_a_second + part * step);
    }
  }
  std::string text = "# description: two streams of people cross, made by throng_samples\n# framerate: " +
                     std::to_string(rows_a_second) + "\n# id frame x/m y/m z/m\n";
  for (const Walker& walker : walkers) {
    for (const std::string& row : walker.rows) text += row;
  }
  return text;
}

std::string crossing_floor() {
  const std::string near = fixed(half_width, 0), far = fixed(half_length, 0);
  std::string text = "POLYGON ((";
  for (const auto& [x, y] : std::to_array<std::array<std::string, 2>>({{"-" + far, "-" + near},
                                                                       {"-" + near, "-" + near},
                                                                       {"-" + near, "-" + far},
                                                                       {near, "-" + far},
                                                                       {near, "-" + near},
                                                                       {far, "-" + near},
                                                                       {far, near},
                                                                       {near, near},
                                                                       {near, far},
                                                                       {"-" + near, far},
                                                                       {"-" + near, near},
                                                                       {"-" + far, near},
                                                                       {"-" + far, "-" + near}})) {
    text += (text.back() == '(' ? "" : ", ") + x + ' ' + y;
  }
  return text + "))\n";
}

}  // namespace throng::samples
