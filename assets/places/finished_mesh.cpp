#include "assets/places/finished_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <tuple>

#include <glm/geometric.hpp>

#include "assets/places/arithmetic.h"
#include "assets/places/openness.h"

namespace throng::places {
namespace {

using PlaceKey = std::tuple<double, double, double, int>;

PlaceKey key_of(dvec3 at, int group) { return {at.x, at.y, at.z, group}; }

/// The finest power of two that still reaches all corners.
double step_for(const std::vector<std::vector<Face>>& levels) {
  double reach = 0;
  for (const auto& faces : levels) {
    for (const Face& face : faces) {
      for (std::size_t c = 0; c < face.count; ++c) {
        const dvec3 p = face.corners[c].position;
        reach = std::max({reach, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
      }
    }
  }
  double step = 1.0 / 2048;
  while (reach / step > 32766) step *= 2;
  return step;
}

void round_places(std::vector<Face>& faces, double step) {
  for (Face& face : faces) {
    for (std::size_t c = 0; c < face.count; ++c) {
      dvec3& p = face.corners[c].position;
      p = dvec3(std::floor(p.x / step + 0.5), std::floor(p.y / step + 0.5), std::floor(p.z / step + 0.5)) * step;
    }
  }
}

dvec3 area_normal(const Face& face) {
  const auto& c = face.corners;
  if (face.count == 3) return glm::cross(c[1].position - c[0].position, c[2].position - c[0].position);
  return glm::cross(c[2].position - c[0].position, c[3].position - c[1].position);
}

/// Faces that rounding made flat lines are dropped; the others get a normal at each corner.
void set_normals(std::vector<Face>& faces) {
  std::erase_if(faces, [](const Face& face) { return glm::length(area_normal(face)) < 1e-9; });
  std::map<PlaceKey, dvec3> shared;
  for (const Face& face : faces) {
    if (face.smooth == 0) continue;
    for (std::size_t c = 0; c < face.count; ++c) {
      shared[key_of(face.corners[c].position, face.smooth)] += area_normal(face);
    }
  }
  for (Face& face : faces) {
    for (std::size_t c = 0; c < face.count; ++c) {
      Corner& corner = face.corners[c];
      if (corner.normal != dvec3(0)) continue;
      dvec3 normal = area_normal(face);
      if (face.smooth != 0) {
        const dvec3 sum = shared[key_of(corner.position, face.smooth)];
        if (glm::length(sum) > 1e-9) normal = sum;
      }
      corner.normal = glm::normalize(normal);
    }
  }
}

std::int8_t signed_byte(double value) {
  return static_cast<std::int8_t>(std::floor(std::clamp(value, -1.0, 1.0) * 127 + 0.5));
}
std::uint8_t byte(double value) {
  return static_cast<std::uint8_t>(std::floor(std::clamp(value, 0.0, 1.0) * 255 + 0.5));
}
std::uint8_t clamped(int value) { return static_cast<std::uint8_t>(std::clamp(value, 0, 255)); }

/// Gives every different vertex a number.
class VertexTable {
 public:
  explicit VertexTable(MadeMesh& mesh) : mesh_(mesh) {}

  std::uint16_t number(const Corner& corner, double openness) {
    MadeVertex made{};
    const dvec3 places = corner.position / mesh_.step;
    made.position = {static_cast<std::int16_t>(places.x), static_cast<std::int16_t>(places.y),
                     static_cast<std::int16_t>(places.z)};
    made.normal = {signed_byte(corner.normal.x), signed_byte(corner.normal.y), signed_byte(corner.normal.z)};
    const dvec3 color = corner.paint.color * openness;
    made.colour = {byte(color.x), byte(color.y), byte(color.z), 255};
    made.surface = {clamped(corner.paint.glow), clamped(corner.paint.tinted), clamped(corner.paint.sway),
                    static_cast<std::uint8_t>(corner.paint.kind)};
    const auto [found, fresh] = known_.try_emplace(made, static_cast<std::uint16_t>(mesh_.vertices.size()));
    if (fresh) mesh_.vertices.push_back(made);
    return found->second;
  }

 private:
  MadeMesh& mesh_;
  std::map<MadeVertex, std::uint16_t> known_;
};

MadeLevel make_level(const std::vector<Face>& faces, const Prop& prop, double error, VertexTable& table) {
  MadeLevel level{.error = error};
  const std::vector<std::array<double, 4>> open = corner_openness(faces, prop.reach);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Face& face = faces[f];
    std::array<std::uint16_t, 4> numbers{};
    for (std::size_t c = 0; c < face.count; ++c) numbers[c] = table.number(face.corners[c], open[f][c]);
    level.indices.insert(level.indices.end(), {numbers[0], numbers[1], numbers[2]});
    if (face.count == 4) level.indices.insert(level.indices.end(), {numbers[0], numbers[2], numbers[3]});
  }
  return level;
}

}  // namespace

MadeMesh finish(const Prop& prop) {
  std::vector<std::vector<Face>> levels;
  for (std::size_t lod = 0; lod < prop.errors.size(); ++lod) {
    MeshBuilder builder;
    prop.build(builder, static_cast<int>(lod));
    levels.push_back(std::move(builder.faces));
  }
  MadeMesh mesh{.name = prop.name, .step = step_for(levels)};
  VertexTable table(mesh);
  for (std::size_t lod = 0; lod < levels.size(); ++lod) {
    round_places(levels[lod], mesh.step);
    set_normals(levels[lod]);
    mesh.levels.push_back(make_level(levels[lod], prop, prop.errors[lod], table));
  }
  return mesh;
}

}  // namespace throng::places
