#include "assets/places/glb.h"

#include <array>
#include <cmath>
#include <string>

#include "assets/making/glb_container.h"

namespace throng::places {
namespace {

using making::BufferWriter;
using making::ComponentType;
using making::Json;
using making::Target;

/// A vertex among others in the file's one view of vertices.
struct FileVertex {
  std::array<std::int16_t, 3> position{};
  std::int16_t no_position = 0;
  std::array<std::int8_t, 3> normal{};
  std::int8_t no_normal = 0;
  std::array<std::uint8_t, 4> colour{};
  std::array<std::uint8_t, 4> surface{};
};
static_assert(sizeof(FileVertex) == 20);

struct Views {
  std::size_t vertices, indices;
};

Views add_views(BufferWriter& buffer, std::span<const MadeMesh> meshes) {
  std::vector<FileVertex> vertices;
  std::vector<std::uint16_t> indices;
  for (const MadeMesh& mesh : meshes) {
    for (const MadeVertex& v : mesh.vertices) vertices.push_back({v.position, 0, v.normal, 0, v.colour, v.surface});
    for (const MadeLevel& level : mesh.levels)
      indices.insert(indices.end(), level.indices.begin(), level.indices.end());
  }
  return {buffer.add_view(std::as_bytes(std::span(vertices)), Target::vertex_data, sizeof(FileVertex)),
          buffer.add_view(std::as_bytes(std::span(indices)), Target::index_data)};
}

Json add_attributes(BufferWriter& buffer, const MadeMesh& mesh, std::size_t view, std::size_t offset) {
  const std::size_t count = mesh.vertices.size();
  std::vector<std::array<std::int16_t, 3>> positions;
  for (const MadeVertex& vertex : mesh.vertices) positions.push_back(vertex.position);
  Json attributes;
  const std::size_t position = buffer.add_accessor(view, offset, count, "VEC3", ComponentType::signed_short);
  buffer.set_bounds<3, std::int16_t>(position, positions);
  attributes["POSITION"] = position;
  attributes["NORMAL"] = buffer.add_accessor(view, offset + 8, count, "VEC3", ComponentType::byte, true);
  attributes["COLOR_0"] = buffer.add_accessor(view, offset + 12, count, "VEC4", ComponentType::unsigned_byte, true);
  attributes["_SURFACE"] = buffer.add_accessor(view, offset + 16, count, "VEC4", ComponentType::unsigned_byte);
  return attributes;
}

double width_of(const MadeMesh& mesh) {
  int reach = 0;
  for (const MadeVertex& vertex : mesh.vertices)
    reach = std::max(reach, std::abs(static_cast<int>(vertex.position[0])));
  return 2 * reach * mesh.step;
}

/// Lays the finest meshes out in a row, so that any viewer shows them all.
class Scene {
 public:
  void add(const MadeMesh& mesh, const Json& attributes, std::size_t indices_view, std::size_t& index_offset,
           BufferWriter& buffer) {
    const double width = width_of(mesh);
    place_ += width / 2;
    for (std::size_t level = 0; level < mesh.levels.size(); ++level) {
      const std::string name = level == 0 ? mesh.name : mesh.name + "." + std::to_string(level);
      const std::size_t count = mesh.levels[level].indices.size();
      const std::size_t indices =
          buffer.add_accessor(indices_view, index_offset, count, "SCALAR", ComponentType::unsigned_short);
      index_offset += count * sizeof(std::uint16_t);
      (level == 0 ? finest_ : coarser_).push_back(nodes_.size());
      nodes_.push_back({{"name", name},
                        {"mesh", meshes_.size()},
                        {"translation", {std::round(place_), 0, 0}},
                        {"scale", {mesh.step, mesh.step, mesh.step}}});
      const Json primitive{{"attributes", attributes}, {"indices", indices}, {"material", 0}};
      meshes_.push_back({{"name", name},
                         {"primitives", Json::array({primitive})},
                         {"extras", {{"error", mesh.levels[level].error}}}});
    }
    place_ += width / 2 + 2;
  }

  void put_into(Json& file) const {
    file["scenes"] =
        Json::array({{{"name", "props"}, {"nodes", finest_}}, {{"name", "coarser levels"}, {"nodes", coarser_}}});
    file["nodes"] = nodes_;
    file["meshes"] = meshes_;
  }

 private:
  Json nodes_ = Json::array(), meshes_ = Json::array(), finest_ = Json::array(), coarser_ = Json::array();
  double place_ = 0;
};

}  // namespace

std::vector<std::byte> write_glb(std::span<const MadeMesh> meshes) {
  BufferWriter buffer;
  const Views views = add_views(buffer, meshes);
  Scene scene;
  std::size_t vertex_offset = 0;
  std::size_t index_offset = 0;
  for (const MadeMesh& mesh : meshes) {
    const Json attributes = add_attributes(buffer, mesh, views.vertices, vertex_offset);
    scene.add(mesh, attributes, views.indices, index_offset, buffer);
    vertex_offset += mesh.vertices.size() * sizeof(FileVertex);
  }
  Json file{{"asset", {{"version", "2.0"}, {"generator", "throng_places"}, {"copyright", "MIT licence"}}},
            {"extensionsUsed", {"KHR_mesh_quantization"}},
            {"extensionsRequired", {"KHR_mesh_quantization"}},
            {"scene", 0}};
  scene.put_into(file);
  file["materials"] = Json::array({{{"name", "props"},
                                    {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0.9}}},
                                    {"doubleSided", true}}});
  buffer.finish(file);
  return making::glb_container(file, buffer.bytes());
}

std::vector<std::byte> make_places() {
  std::vector<MadeMesh> meshes;
  for (const Prop& prop : all_props()) meshes.push_back(finish(prop));
  return write_glb(meshes);
}

}  // namespace throng::places
