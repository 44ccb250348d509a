#include <cmath>
#include <numbers>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/assets/worn_cloth.h"

namespace throng::test::wardrobe_limb_test {
namespace {

using glm::dvec3;
using mannequin::MeshVertex;
using wardrobe::Body;
using wardrobe::Slot;

struct Worn {
  Body body;
  std::vector<std::string> parts;
};
void PrintTo(const Worn& worn, std::ostream* out) { *out << name_of(worn.body) << ' ' << worn.parts.front(); }

bool begins(const MeshVertex& vertex, const char* joint) {
  return mannequin::skeleton()[vertex.joints[0]].name.starts_with(joint);
}

bool of_hand(const MeshVertex& vertex) {
  const std::string& joint = mannequin::skeleton()[vertex.joints[0]].name;
  return joint.starts_with("hand") || joint.find(".1") != std::string::npos || joint.find(".2") != std::string::npos ||
         joint.find(".3") != std::string::npos;
}

bool swings(const MeshVertex& vertex) { return begins(vertex, "forearm") || of_hand(vertex); }

/// Solid angle of a triangle seen from the origin (van Oosterom and Strackee 1983).
double solid_angle(dvec3 a, dvec3 b, dvec3 c) {
  const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
  return 2 * std::atan2(glm::dot(a, glm::cross(b, c)),
                        la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
}

/// Forearms and hands of one moment, and everything but arms that they could enter.
struct Moment {
  std::vector<dvec3> limbs;
  std::vector<Corners> others;
};

Moment moment_of(const std::vector<WornCloth>& outfit, const mannequin::WorldPose& pose) {
  Moment moment;
  for (const WornCloth& cloth : outfit) {
    const std::vector<dvec3> places = places_of(cloth.mesh, pose);
    std::vector<bool> used(places.size());
    for (const auto& [a, b, c] : cloth.mesh.triangles) {
      used[a] = used[b] = used[c] = true;
      const auto& v = cloth.mesh.vertices;
      const bool arm = swings(v[a]) || swings(v[b]) || swings(v[c]) || begins(v[a], "upper_arm");
      const bool lining = cloth.inside[a] && cloth.inside[b] && cloth.inside[c];
      if (!arm && !lining) moment.others.push_back({places[a], places[b], places[c]});
    }
    for (std::size_t p = 0; p < places.size(); ++p) {
      if (used[p] && swings(cloth.mesh.vertices[p])) moment.limbs.push_back(places[p]);
    }
  }
  return moment;
}

/// Returns how deep a place lies inside; 0 outside.
double depth(dvec3 place, const std::vector<Corners>& others) {
  double nearest = 0.06;  // no sleeve is thicker
  bool within = false;
  for (const Corners& t : others) {
    if (glm::distance(t[0], place) > 0.15) continue;
    const dvec3 shares = nearest_shares(place, t);
    const dvec3 there = t[0] * shares.x + t[1] * shares.y + t[2] * shares.z;
    if (glm::distance(there, place) >= nearest) continue;
    nearest = glm::distance(there, place);
    within = glm::dot(place - there, glm::cross(t[1] - t[0], t[2] - t[0])) < 0;
  }
  if (!within) return 0;
  double around = 0;
  for (const Corners& t : others) around += solid_angle(t[0] - place, t[1] - place, t[2] - place);
  return around < 2 * std::numbers::pi ? 0 : nearest;
}

bool rests(const std::string& clip) { return clip.starts_with("sit") || clip == "stand up" || clip == "lean"; }

/// Returns by how many metres cloth gives way to an arm. Arms rest on the cloth of a lap, and the front of a coat does
/// not fall onto the thighs of somebody who sits.
double gives(const std::vector<std::string>& parts, const std::string& clip) {
  if (!rests(clip)) return 0.014;
  return parts.back() == "coat" ? 0.033 : 0.018;
}

class WardrobeLimbs : public ::testing::TestWithParam<Worn> {};

TEST_P(WardrobeLimbs, EnterClothesNoFurtherThanClothGives) {
  std::vector<WornCloth> outfit{worn_skin(Slot::hands, GetParam().body)};
  for (const std::string& name : GetParam().parts) {
    const wardrobe::Part* part = wardrobe::find_part(name, GetParam().body);
    ASSERT_NE(part, nullptr) << name;
    outfit.push_back(worn_part(*part, GetParam().body));
  }
  for (const ClipMoment& at : clip_moments()) {
    const Moment moment = moment_of(outfit, at.pose);
    double worst = 0;
    for (const dvec3 place : moment.limbs) worst = std::max(worst, depth(place, moment.others));
    EXPECT_LE(worst, gives(GetParam().parts, at.clip)) << "in " << at.clip;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Outfits, WardrobeLimbs,
    ::testing::Values(Worn{Body::man, {"jumper", "jeans"}}, Worn{Body::man, {"puffer", "chinos"}},
                      Worn{Body::man, {"hoodie", "track_trousers"}},
                      Worn{Body::man, {"shirt", "suit_trousers", "suit_jacket"}},
                      Worn{Body::man, {"jumper", "jeans", "coat"}}, Worn{Body::woman, {"blouse", "pleated_skirt"}},
                      Worn{Body::woman, {"jumper", "long_skirt"}}, Worn{Body::woman, {"summer_dress"}},
                      Worn{Body::woman, {"rain_jacket", "leggings"}}, Worn{Body::child, {"puffer", "jeans"}},
                      Worn{Body::child, {"t_shirt", "shorts"}}),
    [](const auto& worn) {
      std::string name(name_of(worn.param.body));
      for (const std::string& part : worn.param.parts) name += "_" + part;
      return name;
    });

}  // namespace
}  // namespace throng::test::wardrobe_limb_test
