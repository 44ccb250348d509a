#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "assets/mannequin/clip.h"
#include "assets/wardrobe/finish.h"

namespace throng::test::wardrobe_body_test {
namespace {

using glm::dvec3;
using wardrobe::Finished;

const std::vector<Finished>& bodies() {
  static const std::vector<Finished> pieces = wardrobe::finish_wardrobe({"no part"}, true);
  return pieces;
}

dvec3 posed(const Finished& piece, std::size_t body, std::size_t v, const mannequin::WorldPose& pose) {
  const mannequin::MeshVertex& vertex = piece.made->mesh.vertices[v];
  dvec3 place(0);
  for (std::size_t i = 0; i < 4; ++i) {
    const mannequin::WorldJoint& joint = pose[vertex.joints[i]];
    const dvec3 from_joint = piece.bodies[body].positions[v] - mannequin::skeleton()[vertex.joints[i]].position;
    place += static_cast<double>(vertex.weights[i]) * (joint.position + joint.rotation * from_joint);
  }
  return place;
}

/// Vertices at the open edges of a piece at a level. Vertices at one place count as one.
std::set<std::size_t> border(const Finished& piece, std::size_t level) {
  std::map<std::array<double, 3>, std::size_t> first_at;
  const auto place = [&](std::size_t v) {
    const dvec3& p = piece.bodies[0].positions[v];
    return first_at.try_emplace({p.x, p.y, p.z}, v).first->second;
  };
  std::set<std::pair<std::size_t, std::size_t>> edges;
  const auto& indices = piece.made->levels[level].indices;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    edges.insert({place(indices[i]), place(indices[next])});
  }
  std::set<std::size_t> open;
  for (const auto& [a, b] : edges) {
    if (!edges.contains({b, a})) open.insert({a, b});
  }
  return open;
}

double nearest(const Finished& piece, std::size_t v, std::size_t body, const mannequin::WorldPose& pose,
               const std::vector<std::pair<const Finished*, std::set<std::size_t>>>& borders) {
  const dvec3 here = posed(piece, body, v, pose);
  double least = 1e9;
  for (const auto& [other, vertices] : borders) {
    if (other == &piece) continue;
    for (const std::size_t o : vertices) least = std::min(least, glm::distance(here, posed(*other, body, o, pose)));
  }
  return least;
}

/// The head has open edges of its own: at lids, brows and ears.
TEST(WardrobeBody, PiecesMeetAtTheirCutsInEveryClipAndLevel) {
  const std::vector<mannequin::Clip> clips = mannequin::make_clips();
  for (std::size_t level = 0; level < wardrobe::near_levels; ++level) {
    std::vector<std::pair<const Finished*, std::set<std::size_t>>> borders;
    for (const Finished& piece : bodies()) borders.emplace_back(&piece, border(piece, level));
    for (std::size_t c = level; c < clips.size(); c += wardrobe::near_levels) {
      const mannequin::WorldPose pose = mannequin::world_pose(clips[c].keys[clips[c].keys.size() / 3]);
      for (const auto& [piece, vertices] : borders) {
        if (piece->made->slot == wardrobe::Slot::head) continue;
        for (const std::size_t v : vertices) {
          for (std::size_t body = 0; body < piece->bodies.size(); ++body) {
            ASSERT_LT(nearest(*piece, v, body, pose, borders), 0.001)
                << piece->made->name << " at level " << level << " in " << clips[c].name;
          }
        }
      }
    }
  }
}

TEST(WardrobeBody, AWomanIsNarrowInTheWaistAndAChildHasALargeHead) {
  const auto width = [](std::size_t body, std::size_t slot, double low, double high) {
    double widest = 0;
    for (const dvec3& p : bodies()[slot].bodies[body].positions) {
      if (p.y > low && p.y < high) widest = std::max(widest, 2 * std::abs(p.x));
    }
    return widest;
  };
  const auto torso = static_cast<std::size_t>(wardrobe::Slot::torso);
  const auto head = static_cast<std::size_t>(wardrobe::Slot::head);
  const auto of_hips = [&](std::size_t body) {
    return width(body, torso, 1.03, 1.10) / width(body, torso, 0.93, 0.98);
  };
  EXPECT_LT(of_hips(1), 0.88 * of_hips(0));
  EXPECT_GT(width(2, head, 1.62, 1.90), 1.4 * width(0, head, 1.62, 1.80));
}

}  // namespace
}  // namespace throng::test::wardrobe_body_test
