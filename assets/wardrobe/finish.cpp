#include "assets/wardrobe/finish.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <iterator>
#include <thread>

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
  if (build != nullptr) build->turn_normals(there);
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

/// Returns smaller bounds for a part that lies close on drawn skin, which would show through else.
std::array<double, near_levels - 1> bounds_of(const Part& part) {
  const bool bare_below = std::find(part.covers.begin(), part.covers.end(), Slot::torso) == part.covers.end();
  if (is_on_head(part.slot) || (part.slot == Slot::top && bare_below)) return {0.005, 0.010, 0.018};
  return level_bounds;
}

std::vector<Level> all_levels(const Mesh& mesh, bool with_levels,
                              const std::array<double, near_levels - 1>& bounds = level_bounds) {
  std::vector<Level> levels{whole_level(mesh)};
  if (!with_levels) return levels;
  for (Level& level : coarser_levels(mesh, bounds)) levels.push_back(std::move(level));
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
  const BuildShares build(skin);
  const bool is_cloth = lies_on_skin(part.slot);
  auto made = std::make_shared<MadePart>(MadePart{part.name, part.slot, &part, mannequin::make_mesh(skin), {}});
  if (is_cloth) build.set_shares(made->mesh);
  if (is_on_head(part.slot)) follow_face(made->mesh);
  made->levels = all_levels(made->mesh, with_levels, bounds_of(part));
  const std::vector<double> openness = openness_of(skin, &man_occluder());
  Finished finished{made, {}};
  for (const Body body : all_bodies) {
    if (fits(part.bodies, body))
      finished.bodies.push_back(fit_to(body, skin, made->mesh, openness, is_cloth ? &build : nullptr));
  }
  return finished;
}

/// The piece of a body's mesh, and where its vertices were.
struct BodyPiece {
  std::shared_ptr<MadePart> made;
  std::vector<std::size_t> vertices;
};

BodyPiece cut_piece(const Mesh& body, const std::vector<Level>& levels, Slot slot) {
  BodyPiece piece{std::make_shared<MadePart>(MadePart{std::string(name_of(slot)), slot, nullptr, {}, {}}), {}};
  std::vector<std::uint16_t> moved(body.vertices.size());
  for (std::size_t v = 0; v < body.vertices.size(); ++v) {
    if (body.vertices[v].piece != static_cast<unsigned char>(slot)) continue;
    moved[v] = static_cast<std::uint16_t>(piece.vertices.size());
    piece.vertices.push_back(v);
    piece.made->mesh.vertices.push_back(body.vertices[v]);
  }
  for (const Level& level : levels) {
    Level own{{}, level.error};
    for (std::size_t i = 0; i < level.indices.size(); i += 3) {
      if (body.vertices[level.indices[i]].piece != static_cast<unsigned char>(slot)) continue;
      for (std::size_t c = 0; c < 3; ++c) own.indices.push_back(moved[level.indices[i + c]]);
    }
    piece.made->levels.push_back(std::move(own));
  }
  const std::vector<std::uint16_t>& finest = piece.made->levels.front().indices;
  for (std::size_t i = 0; i < finest.size(); i += 3) {
    piece.made->mesh.triangles.push_back({finest[i], finest[i + 1], finest[i + 2]});
  }
  if (is_on_head(slot)) follow_face(piece.made->mesh);
  return piece;
}

/// The bodies are made whole, so that neighbouring pieces agree along their cuts at every level.
std::vector<Finished> finish_bodies(bool with_levels) {
  Skin skin = body_skin();
  mannequin::compute_normals(skin);
  Mesh mesh = mannequin::make_mesh(skin);
  BuildShares(skin).set_shares(mesh);
  const std::vector<Level> levels = all_levels(mesh, with_levels);
  std::vector<Fitted> bodies;
  for (const Body body : all_bodies) {
    bodies.push_back(fit_to(body, skin, mesh, openness_of(warped_skin(skin, body, nullptr), nullptr), nullptr));
  }
  std::vector<Finished> pieces;
  for (std::size_t slot = 0; slot < piece_count; ++slot) {
    const BodyPiece piece = cut_piece(mesh, levels, static_cast<Slot>(slot));
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
  return all;
}

}  // namespace throng::wardrobe
