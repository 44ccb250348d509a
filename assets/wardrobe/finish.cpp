#include "assets/wardrobe/finish.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <thread>
#include <tuple>
#include <utility>

#include <glm/common.hpp>

#include "assets/mannequin/occlusion.h"
#include "assets/mannequin/shape.h"
#include "assets/wardrobe/body_skin.h"
#include "assets/wardrobe/build_shares.h"
#include "assets/wardrobe/face_shares.h"
#include "assets/wardrobe/levels.h"
#include "assets/wardrobe/pattern.h"
#include "assets/wardrobe/warp.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::Mesh;
using mannequin::MeshVertex;
using mannequin::Skin;

using Triangles = std::vector<std::array<std::size_t, 3>>;

bool lies_on_skin(Slot slot) {
  return slot == Slot::top || slot == Slot::bottom || slot == Slot::outer || slot == Slot::shoes || slot == Slot::back;
}

bool is_on_head(Slot slot) {
  return slot == Slot::head || slot == Slot::hair || slot == Slot::headgear || slot == Slot::face;
}

Skin warped_skin(const Skin& skin, Body body, const BuildShares* build) {
  Skin there = skin;
  for (mannequin::SkinPoint& point : there.points) {
    const dvec3 place = warped(body, point.position, point.weights);
    point.position = glm::round(place / mannequin::position_step) * mannequin::position_step + dvec3(0);
  }
  mannequin::compute_normals(there);
  if (build != nullptr) build->turn_normals(there, body);
  return there;
}

/// Returns how open the surroundings of a skin's points are, with `beside` there too.
std::vector<double> openness_of(const Skin& skin, const Skin* beside) {
  std::vector<dvec3> positions, normals;
  for (const auto& point : skin.points) {
    positions.push_back(point.position);
    normals.push_back(point.normal);
  }
  Triangles triangles = mannequin::triangles_of(skin);
  if (beside != nullptr) {
    const std::size_t first = positions.size();
    for (const auto& point : beside->points) {
      positions.push_back(point.position);
      normals.emplace_back(0);
    }
    for (const auto& [a, b, c] : mannequin::triangles_of(*beside)) {
      triangles.push_back({a + first, b + first, c + first});
    }
  }
  return mannequin::bake_openness(positions, normals, triangles);
}

std::uint8_t darkened(std::uint8_t colour, double openness) {
  return static_cast<std::uint8_t>(std::lround(colour * openness));
}

Fitted fit_to(Body body, const Skin& skin, const Mesh& mesh, const std::vector<double>& openness,
              const BuildShares* build) {
  const Skin there = warped_skin(skin, body, build);
  Fitted fitted{body, {}, {}, {}};
  for (const MeshVertex& vertex : mesh.vertices) {
    const mannequin::SkinPoint& point = there.points[vertex.point];
    fitted.positions.push_back(point.position);
    fitted.normals.push_back(point.normal);
    const double open = openness[vertex.point];
    fitted.colours.push_back(
        {darkened(vertex.colour[0], open), darkened(vertex.colour[1], open), darkened(vertex.colour[2], open), 255});
  }
  return fitted;
}

void follow_face(Mesh& mesh) {
  for (MeshVertex& vertex : mesh.vertices) {
    const glm::dvec4 shares = face_shares(vertex.position);
    vertex.face = glm::round(shares / mannequin::shape_step) * mannequin::shape_step + glm::dvec4(0);
  }
}

bool covers(const Part& part, Slot slot) {
  return std::find(part.covers.begin(), part.covers.end(), slot) != part.covers.end();
}

/// Returns smaller bounds for what lies close on something that would show through else, and for what is small.
std::array<double, near_levels - 1> bounds_of(const Part& part) {
  if (is_on_head(part.slot)) return {0.006, 0.012, 0.030};
  if (part.slot == Slot::outer) return {0.008, 0.016, 0.030};
  if (part.slot == Slot::shoes) return {0.010, 0.020, 0.036};
  const bool hangs_around_thighs = part.slot == Slot::bottom || covers(part, Slot::bottom);
  if (hangs_around_thighs && !covers(part, Slot::thighs)) return {0.006, 0.012, 0.036};
  return level_bounds;
}

/// Points where the bare skin of a garment meets that of the body.
Held points_of_bare_edges(const Mesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  const auto point = [&](std::uint16_t v) { return mesh.vertices[v].point; };
  const auto each_edge = [&](const auto& visit) {
    for (const auto& t : mesh.triangles) {
      for (std::size_t c = 0; c < 3; ++c) visit(t[c], t[(c + 1) % 3]);
    }
  };
  each_edge([&](std::uint16_t a, std::uint16_t b) { edges.insert({point(a), point(b)}); });
  Held held(mesh.vertices.size());
  each_edge([&](std::uint16_t a, std::uint16_t b) {
    const bool is_bare = mesh.vertices[a].region == static_cast<float>(mannequin::Region::skin);
    if (is_bare && !edges.contains({point(b), point(a)})) held[a] = held[b] = mesh.vertices[a].position.y > 1.32F;
  });
  return held;
}

std::vector<Level> all_levels(const Mesh& mesh, bool with_levels, std::span<const double> bounds,
                              const Held& held = {}) {
  if (!with_levels) return {whole_level(mesh)};
  std::vector<Level> levels{finest_level(mesh, held)};
  for (Level& level : coarser_levels(mesh, bounds, levels.front(), held)) levels.push_back(std::move(level));
  return levels;
}

const Skin& man_occluder() {
  static const Skin skin = [] {
    Skin all = body_skin();
    mannequin::compute_normals(all);
    return all;
  }();
  return skin;
}

Finished finish_part(const Part& part, bool with_levels) {
  Skin skin = part.make();
  lay_patterns(skin);
  mannequin::compute_normals(skin);
  std::optional<BuildShares> build;
  if (lies_on_skin(part.slot)) build.emplace(skin);
  auto made = std::make_shared<MadePart>(MadePart{part.name, part.slot, &part, mannequin::make_mesh(skin), {}});
  if (build) build->set_shares(made->mesh);
  if (is_on_head(part.slot)) follow_face(made->mesh);
  made->levels = all_levels(made->mesh, with_levels, bounds_of(part), points_of_bare_edges(made->mesh));
  keep_used(made->mesh, made->levels);
  const std::vector<double> openness = openness_of(skin, &man_occluder());
  Finished finished{made, {}};
  for (const Body body : all_bodies) {
    if (fits(part.bodies, body))
      finished.bodies.push_back(fit_to(body, skin, made->mesh, openness, build ? &*build : nullptr));
  }
  return finished;
}

/// The piece of a body's mesh, and where its vertices were.
struct BodyPiece {
  std::shared_ptr<MadePart> made;
  std::vector<std::size_t> vertices;
};

BodyPiece cut_piece(const Mesh& body, Slot slot) {
  BodyPiece piece{std::make_shared<MadePart>(MadePart{std::string(name_of(slot)), slot, nullptr, {}, {}}), {}};
  std::vector<std::uint16_t> moved(body.vertices.size());
  for (std::size_t v = 0; v < body.vertices.size(); ++v) {
    if (body.vertices[v].piece != static_cast<unsigned char>(slot)) continue;
    moved[v] = static_cast<std::uint16_t>(piece.vertices.size());
    piece.vertices.push_back(v);
    piece.made->mesh.vertices.push_back(body.vertices[v]);
  }
  for (const auto& triangle : body.triangles) {
    if (body.vertices[triangle[0]].piece != static_cast<unsigned char>(slot)) continue;
    piece.made->mesh.triangles.push_back({moved[triangle[0]], moved[triangle[1]], moved[triangle[2]]});
  }
  if (is_on_head(slot)) follow_face(piece.made->mesh);
  return piece;
}

/// The part of a body's level that belongs to a piece.
Level cut_level(const Mesh& body, const Level& level, const BodyPiece& piece) {
  std::map<std::uint16_t, std::uint16_t> moved;
  for (std::size_t v = 0; v < piece.vertices.size(); ++v) {
    moved[static_cast<std::uint16_t>(piece.vertices[v])] = static_cast<std::uint16_t>(v);
  }
  Level own{{}, level.error};
  for (std::size_t i = 0; i < level.indices.size(); i += 3) {
    if (body.vertices[level.indices[i]].piece != static_cast<unsigned char>(piece.made->slot)) continue;
    for (std::size_t c = 0; c < 3; ++c) own.indices.push_back(moved.at(level.indices[i + c]));
  }
  return own;
}

/// Points at which pieces meet.
Held points_of_cuts(const Mesh& body, const BodyPiece& piece) {
  std::map<std::tuple<float, float, float>, unsigned> pieces;
  const auto at = [](const MeshVertex& v) { return std::tuple(v.position.x, v.position.y, v.position.z); };
  for (const MeshVertex& vertex : body.vertices) pieces[at(vertex)] |= 1U << vertex.piece;
  Held held;
  for (const std::size_t v : piece.vertices) {
    held.push_back((pieces[at(body.vertices[v])] & ~(1U << body.vertices[v].piece)) != 0);
  }
  return held;
}

/// At the finer levels each piece has an error of its own, and keeps all points of its cuts. The coarsest level is that
/// of the whole body, so that neighbouring pieces leave out the same points.
void add_levels(const Mesh& body, const Level& coarsest, BodyPiece& piece) {
  const Held held = points_of_cuts(body, piece);
  std::vector<Level>& levels = piece.made->levels;
  levels = all_levels(piece.made->mesh, true, std::span(level_bounds).first(2), held);
  levels.push_back(cut_level(body, coarsest, piece));
  std::vector<std::size_t> kept;
  for (const std::size_t v : keep_used(piece.made->mesh, levels)) kept.push_back(piece.vertices[v]);
  piece.vertices = std::move(kept);
}

/// The bodies are made whole, so that neighbouring pieces agree along their cuts.
std::vector<Finished> finish_bodies(bool with_levels) {
  Skin skin = body_skin();
  mannequin::compute_normals(skin);
  Mesh mesh = mannequin::make_mesh(skin);
  BuildShares(skin).set_shares(mesh);
  const std::vector<Level> levels = all_levels(mesh, with_levels, std::span(level_bounds).last(1));
  std::vector<Fitted> bodies;
  for (const Body body : all_bodies) {
    bodies.push_back(fit_to(body, skin, mesh, openness_of(warped_skin(skin, body, nullptr), nullptr), nullptr));
  }
  std::vector<Finished> pieces;
  for (std::size_t slot = 0; slot < piece_count; ++slot) {
    BodyPiece piece = cut_piece(mesh, static_cast<Slot>(slot));
    if (with_levels) {
      add_levels(mesh, levels.back(), piece);
    } else {
      piece.made->levels = {whole_level(piece.made->mesh)};
    }
    Finished finished{piece.made, {}};
    for (const Fitted& body : bodies) {
      Fitted& own = finished.bodies.emplace_back(Fitted{body.body, {}, {}, {}});
      for (const std::size_t v : piece.vertices) {
        own.positions.push_back(body.positions[v]);
        own.normals.push_back(body.normals[v]);
        own.colours.push_back(body.colours[v]);
      }
    }
    pieces.push_back(std::move(finished));
  }
  return pieces;
}

}  // namespace

std::vector<Finished> finish_wardrobe(const std::vector<std::string>& only, bool with_levels) {
  auto bodies = std::async(std::launch::async, finish_bodies, with_levels);
  std::vector<const Part*> wanted;
  for (const Part& part : all_parts()) {
    if (only.empty() || std::find(only.begin(), only.end(), part.name) != only.end()) wanted.push_back(&part);
  }
  std::vector<Finished> parts(wanted.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < wanted.size(); i = next++) parts[i] = finish_part(*wanted[i], with_levels);
  };
  std::vector<std::future<void>> workers;
  for (unsigned w = 0; w < std::max(2U, std::thread::hardware_concurrency()); ++w) {
    workers.push_back(std::async(std::launch::async, work));
  }
  for (auto& worker : workers) worker.get();
  std::vector<Finished> all = bodies.get();
  std::move(parts.begin(), parts.end(), std::back_inserter(all));
  find_seen_below(all);
  return all;
}

}  // namespace throng::wardrobe
