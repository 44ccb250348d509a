#include <array>
#include <string>

#include <glm/geometric.hpp>

#include "assets/mannequin/body_parts.h"

namespace throng::mannequin {
namespace {

using glm::dvec3;
using FingerRing = std::array<std::size_t, 4>;
constexpr dvec3 knuckle_paint{0.97, 0.93, 0.92};

std::string bone_name(const Finger& finger, int bone) {
  return std::string(finger.name) + "." + std::to_string(bone) + ".L";
}

/// Ring indices: 2 to 5 lie on the back from the little finger's edge to the thumb's, 6, 7, 0, 1 on the palm and
/// return.
LimbRing add_palm_section(Cage& cage, double along, double half_width, double half_height, const Weights& weights) {
  constexpr std::array<double, 8> across{-0.38, -0.94, -0.94, -0.38, 0.38, 0.94, 0.94, 0.38};
  constexpr std::array<double, 8> height{-1.0, -0.75, 0.7, 1.0, 1.0, 0.75, -0.9, -1.05};
  LimbRing ring{};
  for (std::size_t k = 0; k < ring.size(); ++k) {
    ring[k] = cage.add(left_arm().at(along, half_width * across[k], half_height * height[k]), weights);
  }
  return ring;
}

/// The row of webs between the fingers: five vertices on the back and five below them, from the little finger's edge.
struct WebRow {
  std::array<std::size_t, 5> back, palm;
};

WebRow add_webs(Cage& cage) {
  constexpr std::array<double, 5> along{0.636, 0.648, 0.655, 0.654, 0.644};
  constexpr std::array<double, 5> across{-0.0405, -0.0205, 0.0, 0.0215, 0.0430};
  constexpr std::array<double, 5> thickness{0.0090, 0.0108, 0.0112, 0.0110, 0.0095};
  WebRow row{};
  for (std::size_t line = 0; line < 5; ++line) {
    const std::size_t low =
        4 - (line == 0 ? 0 : line - 1);  // fingers count from the thumb, webs from the little finger
    const std::size_t high = 4 - (line == 4 ? 3 : line);
    const auto& fingers = left_fingers();
    const Weights weights =
        bind({{"hand.L", 0.5}, {bone_name(fingers[low], 1), 0.25}, {bone_name(fingers[high], 1), 0.25}});
    row.back[line] = cage.add(left_arm().at(along[line] - 0.010, across[line], thickness[line]), weights);
    row.palm[line] = cage.add(left_arm().at(along[line] + 0.004, across[line], -thickness[line] - 0.002), weights);
  }
  return row;
}

/// Three columns of the palm meet four fingers: the middle one widens to two.
void bridge_to_webs(Cage& cage, const LimbRing& palm, const WebRow& web) {
  const auto& b = web.back;
  const auto& p = web.palm;
  cage.add_face({palm[2], palm[3], b[1], b[0]}, Region::skin);
  cage.add_face({palm[3], palm[4], b[3], b[2], b[1]}, Region::skin);
  cage.add_face({palm[4], palm[5], b[4], b[3]}, Region::skin);
  cage.add_face({palm[5], palm[6], p[4], b[4]}, Region::skin);
  cage.add_face({palm[6], palm[7], p[3], p[4]}, Region::skin);
  cage.add_face({palm[7], palm[0], p[1], p[2], p[3]}, Region::skin);
  cage.add_face({palm[0], palm[1], p[0], p[1]}, Region::skin);
  cage.add_face({palm[1], palm[2], b[0], p[0]}, Region::skin);
}

/// Two axes across a bone, the first towards `hint`, so that (across, up, bone) is right-handed.
struct AcrossBone {
  dvec3 across, up;
  AcrossBone(dvec3 bone, dvec3 hint)
      : across(glm::normalize(hint - bone * glm::dot(hint, bone))), up(glm::cross(bone, across)) {}
};

/// `corners` gives, in the order of the base, the signs of (across, up).
void add_finger(Cage& cage, const Finger& finger, FingerRing base, dvec3 hint,
                const std::array<std::array<double, 2>, 4>& corners) {
  constexpr std::array<double, 3> taper{1.0, 0.92, 0.66};
  for (int bone = 0; bone < 3; ++bone) {
    const auto b = static_cast<std::size_t>(bone);
    const dvec3 next = finger.directions[b < 2 ? b + 1 : b];
    const AcrossBone frame(glm::normalize(finger.directions[b] + next), hint);
    const dvec3 centre = b == 2 ? finger.points[3] - finger.directions[2] * 0.003 : finger.points[b + 1];
    const Weights weights = b == 2 ? bind({{bone_name(finger, 3), 1}})
                                   : bind({{bone_name(finger, bone + 1), 0.5}, {bone_name(finger, bone + 2), 0.5}});
    FingerRing ring{};
    for (std::size_t c = 0; c < 4; ++c) {
      const double half = 0.74 * finger.radius * taper[b];
      ring[c] = cage.add(centre + (frame.across * corners[c][0] + frame.up * corners[c][1]) * half, weights);
    }
    cage.bridge(base, ring, true, Region::skin, b == 2 ? knuckle_paint : paint::plain, b == 1);
    base = ring;
  }
  cage.add_face({base.begin(), base.end()}, Region::skin, knuckle_paint);
}

}  // namespace

void add_hand(Cage& cage, const LimbRing& wrist) {
  const Weights hand = bind({{"hand.L", 1}});
  const Weights thumb_root = bind({{"hand.L", 0.75}, {"thumb.1.L", 0.25}});
  const LimbRing heel = add_palm_section(cage, 0.566, 0.034, 0.0175, hand);
  const LimbRing palm = add_palm_section(cage, 0.604, 0.0415, 0.0150, hand);
  for (const std::size_t k : {5U, 6U}) cage.vertices[heel[k]].weights = cage.vertices[palm[k]].weights = thumb_root;
  cage.bridge(wrist, heel, true, Region::skin);
  for (std::size_t k = 0; k < 8; ++k) {
    const std::size_t next = (k + 1) % 8;
    if (k != 5) cage.add_face({heel[k], heel[next], palm[next], palm[k]}, Region::skin);
  }
  const WebRow web = add_webs(cage);
  bridge_to_webs(cage, palm, web);

  const auto& fingers = left_fingers();
  add_finger(cage, fingers[0], {heel[5], heel[6], palm[6], palm[5]}, left_arm().along,
             {{{-1, 1}, {-1, -1}, {1, -1}, {1, 1}}});
  for (std::size_t line = 0; line < 4; ++line) {
    add_finger(cage, fingers[4 - line], {web.palm[line], web.back[line], web.back[line + 1], web.palm[line + 1]},
               left_arm().backwards, {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}});
  }
}

}  // namespace throng::mannequin
