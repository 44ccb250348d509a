#include "assets/wardrobe/silhouettes.h"

#include <algorithm>
#include <array>
#include <future>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/mannequin/occlusion.h"
#include "assets/wardrobe/levels.h"
#include "assets/wardrobe/warp.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::Mesh;
using mannequin::MeshVertex;

/// A kind of outfit, as it is seen from afar.
struct Kind {
  std::string name;
  std::vector<std::string> parts;
};

const std::array<Kind, 5>& kinds_of_bottom() {
  static const std::array<Kind, 5> kinds{{{"trousers", {"shirt", "chinos", "trainers"}},
                                          {"shorts", {"t_shirt", "shorts", "trainers"}},
                                          {"skirt", {"shirt", "knee_skirt", "trainers"}},
                                          {"long", {"shirt", "long_skirt", "trainers"}},
                                          {"coat", {"coat", "shirt", "chinos", "trainers"}}}};
  return kinds;
}

const std::array<Kind, 3>& kinds_of_hair() {
  static const std::array<Kind, 3> kinds{{{"short", {"short_cut"}}, {"long", {"long_straight"}}, {"hat", {"sun_hat"}}}};
  return kinds;
}

bool is_first_of_its_name(const Part& part) {
  const auto named = [&](const Part& other) { return other.name == part.name; };
  return &*std::find_if(all_parts().begin(), all_parts().end(), named) == &part;
}

/// Joins the second level of the parts, and of the skin that they leave bare, where the man rests. What is worn above
/// the waist is tinted as the outermost layer, whatever that is.
Mesh joined(const std::vector<std::string>& names, std::span<const Finished> parts) {
  std::set<Slot> covered;
  const auto worn = [&](const MadePart& made) {
    if (made.part == nullptr) return true;
    return is_first_of_its_name(*made.part) && std::find(names.begin(), names.end(), made.name) != names.end();
  };
  for (const Finished& finished : parts) {
    if (finished.made->part == nullptr || !worn(*finished.made)) continue;
    covered.insert(finished.made->part->covers.begin(), finished.made->part->covers.end());
  }
  constexpr auto top = static_cast<float>(mannequin::Region::shirt),
                 outer = static_cast<float>(mannequin::Region::outer);
  Mesh all;
  for (const Finished& finished : parts) {
    const MadePart& made = *finished.made;
    if (!worn(made) || covered.contains(made.slot)) continue;
    const std::size_t first = all.vertices.size();
    for (MeshVertex vertex : made.mesh.vertices) {
      vertex.piece = 0;
      vertex.trim = 0;
      if (vertex.region == top) vertex.region = outer;
      all.vertices.push_back(vertex);
    }
    const std::vector<std::uint16_t>& indices = made.levels[std::min<std::size_t>(1, made.levels.size() - 1)].indices;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
      const auto moved = [&](std::size_t k) { return static_cast<std::uint16_t>(first + indices[i + k]); };
      all.triangles.push_back({moved(0), moved(1), moved(2)});
    }
  }
  return all;
}

double area_of(const Mesh& mesh, const std::array<std::uint16_t, 3>& t) {
  const auto at = [&](std::size_t k) { return dvec3(mesh.vertices[t[k]].position); };
  return 0.5 * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
}

/// Leaves out small things (eyes, brows, buttons) and what lies below something else.
void drop_unseen(Mesh& mesh) {
  constexpr double least_area = 0.012;     // square metres
  constexpr double least_openness = 0.47;  // bake_openness gives 0.38 below cloth
  std::map<std::tuple<float, float, float>, std::size_t> places;
  std::vector<std::size_t> place_of(mesh.vertices.size()), group;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const glm::vec3 p = mesh.vertices[v].position;
    place_of[v] = places.try_emplace({p.x, p.y, p.z}, places.size()).first->second;
  }
  group.resize(places.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  const auto root = [&](std::size_t g) {
    while (group[g] != g) g = group[g] = group[group[g]];
    return g;
  };
  for (const auto& t : mesh.triangles) {
    for (const std::size_t k : {1U, 2U}) group[root(place_of[t[k]])] = root(place_of[t[0]]);
  }
  std::map<std::size_t, double> areas;
  for (const auto& t : mesh.triangles) areas[root(place_of[t[0]])] += area_of(mesh, t);

  std::vector<dvec3> positions, normals(mesh.vertices.size(), dvec3(0));
  std::vector<std::array<std::size_t, 3>> triangles;
  for (const MeshVertex& vertex : mesh.vertices) positions.emplace_back(vertex.position);
  for (const auto& t : mesh.triangles) {
    triangles.push_back({t[0], t[1], t[2]});
    for (const std::uint16_t v : t) normals[v] = mesh.vertices[v].normal;
  }
  const std::vector<double> openness = mannequin::bake_openness(positions, normals, triangles);
  std::erase_if(mesh.triangles, [&](const std::array<std::uint16_t, 3>& t) {
    if (areas[root(place_of[t[0]])] < least_area || mesh.vertices[t[0]].region == 5.0F) return true;
    return std::all_of(t.begin(), t.end(), [&](std::uint16_t v) { return openness[v] < least_openness; });
  });
}

mannequin::Weights all_weights(const MeshVertex& vertex) {
  mannequin::Weights weights{};
  for (std::size_t i = 0; i < 4; ++i) weights[vertex.joints[i]] += static_cast<double>(vertex.weights[i]);
  return weights;
}

Finished finish_silhouette(const std::string& name, Mesh mesh) {
  drop_unseen(mesh);
  std::vector<Level> levels = far_levels(mesh, silhouette_levels);
  keep_used(mesh, levels);
  for (MeshVertex& vertex : mesh.vertices) {
    vertex.pattern = glm::vec2(0);
    vertex.hair = glm::vec2(0);
  }
  Finished finished{
      std::make_shared<MadePart>(MadePart{name, Slot::silhouette, nullptr, std::move(mesh), std::move(levels)}), {}};
  for (const Body body : all_bodies) {
    Fitted& fitted = finished.bodies.emplace_back(Fitted{body, {}, {}, {}});
    for (const MeshVertex& vertex : finished.made->mesh.vertices) {
      fitted.positions.push_back(warped(body, vertex.position, all_weights(vertex)));
      fitted.normals.emplace_back(vertex.normal);
      fitted.colours.push_back(vertex.colour);
    }
  }
  return finished;
}

}  // namespace

std::vector<std::string> silhouette_parts() {
  std::vector<std::string> names;
  for (const Kind& kind : kinds_of_bottom()) names.insert(names.end(), kind.parts.begin(), kind.parts.end());
  for (const Kind& kind : kinds_of_hair()) names.insert(names.end(), kind.parts.begin(), kind.parts.end());
  return names;
}

std::vector<Finished> make_silhouettes(std::span<const Finished> parts) {
  std::vector<std::future<Finished>> made;
  for (const Kind& bottom : kinds_of_bottom()) {
    for (const Kind& hair : kinds_of_hair()) {
      std::vector<std::string> names = bottom.parts;
      names.insert(names.end(), hair.parts.begin(), hair.parts.end());
      made.push_back(std::async(std::launch::async, finish_silhouette, "silhouette/" + bottom.name + "/" + hair.name,
                                joined(names, parts)));
    }
  }
  std::vector<Finished> silhouettes;
  for (std::future<Finished>& each : made) silhouettes.push_back(each.get());
  return silhouettes;
}

}  // namespace throng::wardrobe
