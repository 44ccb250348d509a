// The triangles of tops that are seen below coats, jackets and waistcoats.
#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "assets/making/triangle.h"
#include "assets/mannequin/skeleton.h"
#include "assets/wardrobe/finish.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using making::RayTriangle;
using mannequin::Mesh;
using mannequin::MeshVertex;

/// Outer clothes by what they cover, as their tags say.
constexpr std::array<const char*, 2> tags_of_outer{"sleeved", "sleeveless"};

constexpr double reach = 0.25;  // metres; cloth that is farther away hides nothing

bool has_tag(const Finished& finished, const std::string& tag) {
  const Part* part = finished.made->part;
  return part != nullptr && std::ranges::find(part->tags, tag) != part->tags.end();
}

bool goes_below(const MadePart& made) {
  return made.part != nullptr && made.slot == Slot::top &&
         std::ranges::find(made.part->keeps_out, Slot::outer) == made.part->keeps_out.end();
}

std::vector<RayTriangle> cloth_near(const Mesh& outer, dvec3 place) {
  std::vector<RayTriangle> near;
  for (const auto& t : outer.triangles) {
    const dvec3 corner = outer.vertices[t[0]].position;
    if (glm::distance(corner, place) > 1.5 * reach) continue;
    near.push_back(
        {corner, dvec3(outer.vertices[t[1]].position) - corner, dvec3(outer.vertices[t[2]].position) - corner});
  }
  return near;
}

/// Returns the directions from which a point may be seen: along its normal, and well aside of that. Nobody looks from
/// far below.
std::vector<dvec3> ways_from(dvec3 normal) {
  constexpr int around = 8;
  const dvec3 aside = glm::normalize(glm::cross(normal, std::abs(normal.y) < 0.8 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
  const dvec3 across = glm::cross(normal, aside);
  std::vector<dvec3> ways{normal};
  for (const double tilt : {0.7, 1.2}) {
    for (int i = 0; i < around; ++i) {
      const double turn = 2 * std::numbers::pi * i / around;
      ways.push_back(std::cos(tilt) * normal + std::sin(tilt) * (std::cos(turn) * aside + std::sin(turn) * across));
    }
  }
  std::erase_if(ways, [](dvec3 way) { return way.y < -0.7; });
  return ways;
}

/// Returns whether a point lies in an armpit, where layers of cloth cross each other when an arm is raised.
bool is_in_armpit(const MeshVertex& vertex) {
  double arm = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool is_arms = mannequin::skeleton()[vertex.joints[i]].name.starts_with("upper_arm");
    if (is_arms) arm += static_cast<double>(vertex.weights[i]);
  }
  return arm > 0.05 && arm < 0.98 && vertex.normal.y < -0.25F;
}

bool is_hidden(const MeshVertex& vertex, const Mesh& outer) {
  constexpr double poking_out = 0.008;  // metres
  const dvec3 normal = glm::normalize(dvec3(vertex.normal)), place = dvec3(vertex.position) - poking_out * normal;
  const std::vector<RayTriangle> near = cloth_near(outer, place);
  return std::ranges::all_of(ways_from(normal), [&](dvec3 way) {
    return std::ranges::any_of(near, [&](const RayTriangle& cloth) { return hit(cloth, place, way, reach) < reach; });
  });
}

/// Hides hems and linings, which face another way, with the cloth that they are sewn to.
void hide_linings(const Mesh& mesh, std::vector<bool>& hidden) {
  constexpr double thickness = 0.012, other_way = 0.5;
  const std::vector<bool> outside = hidden;
  for (std::size_t v = 0; v < hidden.size(); ++v) {
    std::size_t sewn_to = 0, of_these_hidden = 0;
    for (std::size_t o = 0; o < hidden.size(); ++o) {
      const MeshVertex &one = mesh.vertices[v], &other = mesh.vertices[o];
      if (glm::distance(dvec3(one.position), dvec3(other.position)) > thickness) continue;
      if (glm::dot(dvec3(one.normal), dvec3(other.normal)) > other_way) continue;
      ++sewn_to;
      of_these_hidden += outside[o] ? 1U : 0U;
    }
    if (of_these_hidden > 0 && 2 * of_these_hidden >= sewn_to) hidden[v] = true;
  }
}

Level seen_of(const Level& level, const std::vector<bool>& hidden) {
  Level seen{{}, level.error};
  for (std::size_t i = 0; i < level.indices.size(); i += 3) {
    const auto triangle = std::span(level.indices).subspan(i, 3);
    if (std::ranges::all_of(triangle, [&](std::uint16_t v) { return hidden[v]; })) continue;
    seen.indices.insert(seen.indices.end(), triangle.begin(), triangle.end());
  }
  return seen;
}

void find_seen(MadePart& made, std::span<const Finished> parts) {
  for (const std::string tag : tags_of_outer) {
    const bool is_sleeved = tag == tags_of_outer.front();
    std::vector<bool> hidden;
    for (const MeshVertex& vertex : made.mesh.vertices) {
      hidden.push_back(std::ranges::all_of(parts, [&](const Finished& outer) {
        return !has_tag(outer, tag) || (is_sleeved && is_in_armpit(vertex)) || is_hidden(vertex, outer.made->mesh);
      }));
    }
    hide_linings(made.mesh, hidden);
    Below below{tag, {}};
    for (const Level& level : made.levels) below.levels.push_back(seen_of(level, hidden));
    const bool has_all = std::ranges::none_of(below.levels, [](const Level& level) { return level.indices.empty(); });
    if (has_all) made.below.push_back(std::move(below));
  }
}

}  // namespace

void find_seen_below(std::span<const Finished> parts) {
  std::vector<std::future<void>> found;
  for (const Finished& finished : parts) {
    if (goes_below(*finished.made)) {
      found.push_back(std::async(std::launch::async, [&] { find_seen(*finished.made, parts); }));
    }
  }
  for (std::future<void>& each : found) each.get();
}

}  // namespace throng::wardrobe
