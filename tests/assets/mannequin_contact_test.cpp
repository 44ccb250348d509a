#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "assets/making/triangle.h"
#include "tests/assets/character_file.h"
#include "tests/assets/clip_list.h"

namespace throng::test::mannequin_contact_test {
namespace {

using glm::dvec3;

/// Where on the body a vertex is, by its strongest joint.
enum class Part : std::uint8_t { trunk, left_arm, right_arm, left_leg, right_leg };

Part part_of(const std::string& joint) {
  for (const char* leg : {"thigh", "shin", "foot", "toe"}) {
    if (joint.starts_with(leg)) return joint.ends_with(".L") ? Part::left_leg : Part::right_leg;
  }
  const bool shoulder = joint.starts_with("shoulder");
  if (shoulder || joint.starts_with("eye")) return Part::trunk;
  if (joint.ends_with(".L")) return Part::left_arm;
  return joint.ends_with(".R") ? Part::right_arm : Part::trunk;
}

/// Forearms, hands, shins and feet: what swings about. Above them limb and trunk are one skin that folds.
bool swings(const std::string& joint) {
  for (const char* upper : {"upper_arm", "thigh", "shoulder"}) {
    if (joint.starts_with(upper)) return false;
  }
  return part_of(joint) != Part::trunk;
}

dvec3 nearest_on_triangle(dvec3 p, dvec3 a, dvec3 b, dvec3 c) {
  const dvec3 shares = making::nearest_shares(p, a, b, c);
  return shares.x * a + shares.y * b + shares.z * c;
}

/// Solid angle of a triangle seen from the origin (van Oosterom and Strackee 1983).
double solid_angle(dvec3 a, dvec3 b, dvec3 c) {
  const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
  return 2 * std::atan2(glm::dot(a, glm::cross(b, c)),
                        la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
}

class MannequinContact : public ::testing::TestWithParam<const char*> {
 protected:
  MannequinContact() {
    const std::vector<std::string> names = file_.joint_names();
    const std::vector<double> joints = file_.attribute("JOINTS_0");
    for (std::size_t v = 0; v < joints.size() / 4; ++v) {
      const std::string& strongest = names[static_cast<std::size_t>(joints[4 * v])];
      part_.push_back(part_of(strongest));
      swings_.push_back(swings(strongest));
    }
    const std::vector<double> indices = file_.values(file_.primitive()["indices"]);
    for (std::size_t t = 0; t < indices.size(); t += 3) {
      triangles_.push_back({static_cast<std::size_t>(indices[t]), static_cast<std::size_t>(indices[t + 1]),
                            static_cast<std::size_t>(indices[t + 2])});
    }
  }

  /// How deep a point lies inside the skin of all parts but its own; 0 outside.
  [[nodiscard]] double depth(const std::vector<dvec3>& skin, dvec3 point, Part own) const {
    double around = 0;
    double nearest = 1;
    for (const auto& [a, b, c] : triangles_) {
      if (part_[a] == own) continue;
      around += solid_angle(skin[a] - point, skin[b] - point, skin[c] - point);
    }
    if (around < 2 * std::numbers::pi) return 0;  // half of what it is inside: the skin is open where the limb goes on
    for (const auto& [a, b, c] : triangles_) {
      if (part_[a] == own) continue;
      nearest = std::min(nearest, glm::distance(point, nearest_on_triangle(point, skin[a], skin[b], skin[c])));
    }
    return nearest;
  }

  /// Whether anything but its own limb is near enough to be met.
  [[nodiscard]] bool meets_nothing(const std::vector<dvec3>& skin, dvec3 point, Part own) const {
    constexpr double reach = 0.06;  // no point inside a body is further from a vertex of it, but in the middle of it
    double nearest = 1;
    for (std::size_t v = 0; v < skin.size(); ++v) {
      if (part_[v] != own) nearest = std::min(nearest, glm::distance(skin[v], point));
    }
    return nearest > 3 * reach;
  }

  CharacterFile file_ = CharacterFile::committed();
  Playback clip_{file_, GetParam()};
  std::vector<Part> part_;
  std::vector<bool> swings_;
  std::vector<std::array<std::size_t, 3>> triangles_;
};

TEST_P(MannequinContact, KeepsForearmsHandsShinsAndFeetOutOfTheRestOfTheBody) {
  constexpr double deepest = 0.010;
  const int frames = static_cast<int>(std::ceil(clip_.duration() * 8));
  double worst = 0;
  double worst_time = 0;
  std::size_t worst_vertex = 0;
  for (int frame = 0; frame < frames; ++frame) {
    const double time = clip_.duration() * frame / frames;
    const std::vector<dvec3> skin = clip_.skin(time);
    for (std::size_t v = 0; v < skin.size(); ++v) {
      if (!swings_[v] || meets_nothing(skin, skin[v], part_[v])) continue;
      const double inside = depth(skin, skin[v], part_[v]);
      if (inside <= worst) continue;
      worst = inside;
      worst_time = time;
      worst_vertex = v;
    }
  }
  const auto joint = static_cast<std::size_t>(file_.attribute("JOINTS_0")[4 * worst_vertex]);
  EXPECT_LE(worst, deepest) << "metres, of " << file_.joint_names()[joint] << " at " << worst_time << " s";
  RecordProperty("deepest_millimetres", std::to_string(worst * 1000));
}

INSTANTIATE_TEST_SUITE_P(Clips, MannequinContact, ::testing::ValuesIn(clip_list), spaceless_clip_name);

}  // namespace
}  // namespace throng::test::mannequin_contact_test
