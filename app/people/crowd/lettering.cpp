#include "app/people/crowd/lettering.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace throng::app {
namespace {

struct Stroke {
  glm::dvec2 from, to;
};

// A letter is 0.72 wide and 1 high. Its round parts have cut corners, as on a jersey.
constexpr double letter_pitch = 1.08;

constexpr std::array<Stroke, 2> letter_t{{{{0.0, 1.0}, {0.72, 1.0}}, {{0.36, 1.0}, {0.36, 0.0}}}};
constexpr std::array<Stroke, 3> letter_h{
    {{{0.0, 1.0}, {0.0, 0.0}}, {{0.72, 1.0}, {0.72, 0.0}}, {{0.0, 0.5}, {0.72, 0.5}}}};
constexpr std::array<Stroke, 7> letter_r{{{{0.0, 0.0}, {0.0, 1.0}},
                                          {{0.0, 1.0}, {0.52, 1.0}},
                                          {{0.52, 1.0}, {0.70, 0.84}},
                                          {{0.70, 0.84}, {0.70, 0.62}},
                                          {{0.70, 0.62}, {0.52, 0.46}},
                                          {{0.52, 0.46}, {0.0, 0.46}},
                                          {{0.40, 0.46}, {0.72, 0.0}}}};
constexpr std::array<Stroke, 8> letter_o{{{{0.18, 0.0}, {0.54, 0.0}},
                                          {{0.54, 0.0}, {0.72, 0.18}},
                                          {{0.72, 0.18}, {0.72, 0.82}},
                                          {{0.72, 0.82}, {0.54, 1.0}},
                                          {{0.54, 1.0}, {0.18, 1.0}},
                                          {{0.18, 1.0}, {0.0, 0.82}},
                                          {{0.0, 0.82}, {0.0, 0.18}},
                                          {{0.0, 0.18}, {0.18, 0.0}}}};
constexpr std::array<Stroke, 3> letter_n{
    {{{0.0, 0.0}, {0.0, 1.0}}, {{0.0, 1.0}, {0.72, 0.0}}, {{0.72, 0.0}, {0.72, 1.0}}}};
constexpr std::array<Stroke, 9> letter_g{{{{0.72, 0.82}, {0.54, 1.0}},
                                          {{0.54, 1.0}, {0.18, 1.0}},
                                          {{0.18, 1.0}, {0.0, 0.82}},
                                          {{0.0, 0.82}, {0.0, 0.18}},
                                          {{0.0, 0.18}, {0.18, 0.0}},
                                          {{0.18, 0.0}, {0.54, 0.0}},
                                          {{0.54, 0.0}, {0.72, 0.18}},
                                          {{0.72, 0.18}, {0.72, 0.46}},
                                          {{0.72, 0.46}, {0.44, 0.46}}}};

double distance_to(const Stroke& stroke, glm::dvec2 at) {
  const glm::dvec2 along = stroke.to - stroke.from;
  const double share = glm::clamp(glm::dot(at - stroke.from, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::distance(at, stroke.from + share * along);
}

}  // namespace

double distance_to_word(glm::dvec2 at) {
  const std::array<std::span<const Stroke>, 6> word{letter_t, letter_h, letter_r, letter_o, letter_n, letter_g};
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t letter = 0; letter < word.size(); ++letter) {
    const glm::dvec2 within = at - glm::dvec2(static_cast<double>(letter) * letter_pitch, 0.0);
    for (const Stroke& stroke : word[letter]) nearest = std::min(nearest, distance_to(stroke, within));
  }
  return nearest;
}

}  // namespace throng::app
