#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "assets/wardrobe/finish.h"

namespace throng::test::wardrobe_build_test {
namespace {

using glm::dvec3;
using wardrobe::Finished;
using wardrobe::Fitted;

constexpr double stout_reach = 0.048, broad_reach = 0.026;  // as shaders/variants.glsl has them

const std::vector<Finished>& clothes() {
  static const std::vector<Finished> parts = [] {
    std::vector<Finished> all = wardrobe::finish_wardrobe(
        {"t_shirt", "shirt", "jumper", "suit_jacket", "coat", "jeans", "knee_skirt", "summer_dress"}, false);
    std::erase_if(all, [](const Finished& part) { return part.made->part == nullptr; });
    return all;
  }();
  return parts;
}

/// Returns the place to which the shader moves a vertex for a build and a frame, from -1 to 1.
dvec3 moved(const Finished& part, const Fitted& body, std::size_t v, double build, double frame) {
  const glm::dvec3 shape = part.made->mesh.vertices[v].shape;
  return body.positions[v] + body.normals[v] * (stout_reach * build * shape.x + broad_reach * frame * shape.y);
}

/// A hem is sewn of two edges that lie at one place.
TEST(WardrobeBuild, HemsStaySewnWhoeverWearsThem) {
  constexpr double widest_gap = 0.025;  // between the ends of all builds
  ASSERT_EQ(clothes().size(), 8U);
  for (const Finished& part : clothes()) {
    for (const Fitted& body : part.bodies) {
      std::map<std::array<double, 3>, std::size_t> first_at;
      std::size_t seams = 0;
      for (std::size_t v = 0; v < body.positions.size(); ++v) {
        const dvec3 at = body.positions[v];
        const auto [first, fresh] = first_at.try_emplace({at.x, at.y, at.z}, v);
        if (fresh) continue;
        ++seams;
        for (const double build : {-1.0, 1.0}) {
          for (const double frame : {-1.0, 1.0}) {
            EXPECT_LT(glm::distance(moved(part, body, v, build, frame), moved(part, body, first->second, build, frame)),
                      widest_gap)
                << part.made->name << " of a " << name_of(body.body) << " at " << at.x << ' ' << at.y << ' ' << at.z;
          }
        }
      }
      EXPECT_GT(seams, 20U) << part.made->name;
    }
  }
}

}  // namespace
}  // namespace throng::test::wardrobe_build_test
