#include "assets/wardrobe/glb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>

#include "assets/making/glb_container.h"
#include "assets/mannequin/glb.h"
#include "assets/wardrobe/silhouettes.h"

namespace throng::wardrobe {
namespace {

using making::BufferWriter;
using making::ComponentType;
using making::Json;
using making::Target;
using mannequin::MeshVertex;

using Bytes4 = std::array<std::uint8_t, 4>;
using Signs4 = std::array<std::int8_t, 4>;

std::int8_t to_sign(double value) { return static_cast<std::int8_t>(std::lround(std::clamp(value, -1.0, 1.0) * 127)); }

/// Weights in bytes that add up to 255: the largest takes what rounding leaves.
Bytes4 weights_of(const MeshVertex& vertex) {
  Bytes4 bytes{};
  int left = 255;
  for (std::size_t i = 3; i > 0; --i) {
    bytes[i] = static_cast<std::uint8_t>(std::lround(static_cast<double>(vertex.weights[i]) * 255));
    left -= bytes[i];
  }
  bytes[0] = static_cast<std::uint8_t>(left);
  return bytes;
}

Bytes4 joints_of(const MeshVertex& vertex) {
  Bytes4 joints = vertex.joints;
  const Bytes4 weights = weights_of(vertex);
  for (std::size_t i = 0; i < 4; ++i) {
    if (weights[i] == 0) joints[i] = 0;
  }
  return joints;
}

/// Views of elements of 4 or 8 bytes, all of one kind in one view, so that the file names few.
class AttributeWriter {
 public:
  AttributeWriter(BufferWriter& buffer, Json& attributes) : buffer_(buffer), attributes_(attributes) {}

  template <typename Element, typename Values>
  std::size_t add(const char* name, const Values& values, const char* type, ComponentType component, bool normalized) {
    static_assert(sizeof(Element) % 4 == 0);
    const std::vector<Element> elements(values.begin(), values.end());
    const std::size_t view = buffer_.add_view(std::as_bytes(std::span(elements)), Target::vertex_data, sizeof(Element));
    const std::size_t accessor = buffer_.add_accessor(view, 0, elements.size(), type, component, normalized);
    attributes_[name] = accessor;
    return accessor;
  }

 private:
  BufferWriter& buffer_;
  Json& attributes_;
};

template <typename Element, typename Member>
std::vector<Element> column(const mannequin::Mesh& mesh, Member member) {
  std::vector<Element> values;
  for (const MeshVertex& vertex : mesh.vertices) values.push_back(member(vertex));
  return values;
}

bool any(const mannequin::Mesh& mesh, bool (*has)(const MeshVertex&)) {
  return std::any_of(mesh.vertices.begin(), mesh.vertices.end(), has);
}

/// Adds the attributes that all bodies share. One that would be 0 everywhere is left out.
Json add_shared(BufferWriter& buffer, const MadePart& made) {
  Json attributes;
  AttributeWriter write(buffer, attributes);
  const mannequin::Mesh& mesh = made.mesh;
  write.add<Bytes4>("JOINTS_0", column<Bytes4>(mesh, joints_of), "VEC4", ComponentType::unsigned_byte, false);
  write.add<Bytes4>("WEIGHTS_0", column<Bytes4>(mesh, weights_of), "VEC4", ComponentType::unsigned_byte, true);
  write.add<Bytes4>("_REGION",
                    column<Bytes4>(mesh,
                                   [](const MeshVertex& v) {
                                     return Bytes4{static_cast<std::uint8_t>(v.region), 0, 0, 0};
                                   }),
                    "SCALAR", ComponentType::unsigned_byte, false);
  write.add<Signs4>("_SHAPE",
                    column<Signs4>(mesh,
                                   [](const MeshVertex& v) {
                                     return Signs4{to_sign(static_cast<double>(v.shape.x)),
                                                   to_sign(static_cast<double>(v.shape.y)),
                                                   to_sign(static_cast<double>(v.shape.z)), 0};
                                   }),
                    "VEC3", ComponentType::byte, true);
  if (any(mesh, [](const MeshVertex& v) { return v.pattern != glm::vec2(0); })) {
    using Float2 = std::array<float, 2>;
    write.add<Float2>("TEXCOORD_0",
                      column<Float2>(mesh,
                                     [](const MeshVertex& v) {
                                       return Float2{v.pattern.x, v.pattern.y};
                                     }),
                      "VEC2", ComponentType::float32, false);
  }
  if (any(mesh, [](const MeshVertex& v) { return v.hair != glm::vec2(0); })) {
    write.add<Signs4>(
        "_HAIR",
        column<Signs4>(
            mesh,
            [](const MeshVertex& v) {
              return Signs4{to_sign(static_cast<double>(v.hair.x)), to_sign(static_cast<double>(v.hair.y)), 0, 0};
            }),
        "VEC2", ComponentType::byte, true);
  }
  if (any(mesh, [](const MeshVertex& v) { return v.trim > 0; })) {
    write.add<Bytes4>(
        "_TRIM",
        column<Bytes4>(
            mesh,
            [](const MeshVertex& v) {
              return Bytes4{static_cast<std::uint8_t>(std::lround(static_cast<double>(v.trim) * 255)), 0, 0, 0};
            }),
        "SCALAR", ComponentType::unsigned_byte, true);
  }
  if (any(mesh, [](const MeshVertex& v) { return v.face != glm::vec4(0); })) {
    write.add<Signs4>(
        "_FACE",
        column<Signs4>(mesh,
                       [](const MeshVertex& v) {
                         return Signs4{to_sign(static_cast<double>(v.face.x)), to_sign(static_cast<double>(v.face.y)),
                                       to_sign(static_cast<double>(v.face.z)), to_sign(static_cast<double>(v.face.w))};
                       }),
        "VEC4", ComponentType::byte, true);
  }
  return attributes;
}

/// Adds the attributes that a body has of its own.
Json add_fitted(BufferWriter& buffer, const Fitted& fitted, Json attributes) {
  std::vector<std::array<std::int16_t, 4>> positions;
  std::vector<std::array<std::int16_t, 3>> bounds;
  for (const glm::dvec3& p : fitted.positions) {
    const glm::dvec3 steps = glm::round(p / written_step);
    bounds.push_back(
        {static_cast<std::int16_t>(steps.x), static_cast<std::int16_t>(steps.y), static_cast<std::int16_t>(steps.z)});
    positions.push_back({bounds.back()[0], bounds.back()[1], bounds.back()[2], 0});
  }
  std::vector<Signs4> normals;
  for (const glm::dvec3& normal : fitted.normals) {
    const glm::dvec3 n = normal == glm::dvec3(0) ? glm::dvec3(0, 1, 0) : normal;  // of a point that no face has
    normals.push_back({to_sign(n.x), to_sign(n.y), to_sign(n.z), 0});
  }
  AttributeWriter write(buffer, attributes);
  const std::size_t position =
      write.add<std::array<std::int16_t, 4>>("POSITION", positions, "VEC3", ComponentType::signed_short, false);
  buffer.set_bounds<3, std::int16_t>(position, bounds);
  write.add<Signs4>("NORMAL", normals, "VEC3", ComponentType::byte, true);
  return attributes;
}

Json names_of(const std::vector<Slot>& slots) {
  Json names = Json::array();
  for (const Slot slot : slots) names.push_back(name_of(slot));
  return names;
}

Json extras_of(const MadePart& made, Body body) {
  Json extras{{"slot", name_of(made.slot)}, {"body", name_of(body)}};
  if (made.slot == Slot::silhouette) extras["error"] = made.levels.front().error;
  if (made.part == nullptr) return extras;
  if (!made.part->covers.empty()) extras["covers"] = names_of(made.part->covers);
  if (!made.part->tags.empty()) extras["tags"] = made.part->tags;
  if (!made.part->keeps_out.empty()) extras["keeps_out"] = names_of(made.part->keeps_out);
  return extras;
}

class WardrobeWriter {
 public:
  WardrobeWriter() : nodes_(mannequin::joint_nodes()) { finest_.push_back(0); }

  void add(const Finished& finished) {
    const MadePart& made = *finished.made;
    const Json shared = add_shared(buffer_, made);
    const std::vector<std::size_t> indices = indices_of(made.levels);
    std::vector<std::vector<std::size_t>> indices_below;
    for (const Below& below : made.below) indices_below.push_back(indices_of(below.levels));
    for (const Fitted& fitted : finished.bodies) {
      Json attributes = add_fitted(buffer_, fitted, shared);
      const auto [found, fresh] = colours_.try_emplace(fitted.colours, 0);
      if (fresh) {
        AttributeWriter write(buffer_, attributes);
        found->second = write.add<Bytes4>("COLOR_0", fitted.colours, "VEC4", ComponentType::unsigned_byte, true);
      }
      attributes["COLOR_0"] = found->second;
      add_nodes(made, {fitted.body, made.name}, attributes, indices);
      for (std::size_t b = 0; b < indices_below.size(); ++b) {
        const std::string name = made.name + "/below_" + made.below[b].tag;
        add_nodes(made, {fitted.body, name}, attributes, indices_below[b]);
      }
    }
  }

  std::vector<std::byte> finish() {
    Json file{{"asset", {{"version", "2.0"}, {"generator", "throng_wardrobe"}, {"copyright", "MIT licence"}}},
              {"extensionsUsed", {"KHR_mesh_quantization"}},
              {"extensionsRequired", {"KHR_mesh_quantization"}},
              {"scene", 0},
              {"scenes", Json::array({{{"name", "parts"}, {"nodes", finest_}}})}};
    if (coarser_.size() > 1) file["scenes"].push_back({{"name", "coarser levels"}, {"nodes", coarser_}});
    file["nodes"] = nodes_;
    file["meshes"] = meshes_;
    file["materials"] = Json::array(
        {{{"name", "wardrobe"}, {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0.85}}}}});
    add_skin(file);
    buffer_.finish(file);
    return making::glb_container(file, buffer_.bytes());
  }

 private:
  std::size_t indices_of(const Level& level) {
    return buffer_.add<std::uint16_t>(level.indices, "SCALAR", ComponentType::unsigned_short, Target::index_data);
  }

  std::vector<std::size_t> indices_of(const std::vector<Level>& levels) {
    std::vector<std::size_t> indices;
    for (const Level& level : levels) indices.push_back(indices_of(level));
    return indices;
  }

  struct NodeName {
    Body body;
    std::string part;
  };
  void add_nodes(const MadePart& made, const NodeName& named, const Json& attributes,
                 const std::vector<std::size_t>& indices) {
    const std::string name = std::string(name_of(named.body)) + "/" + named.part;
    const std::size_t node = nodes_.size();
    finest_.push_back(node);
    Json lods = Json::array();
    for (std::size_t level = 0; level < indices.size(); ++level) {
      nodes_.push_back(
          {{"name", level == 0 ? name : name + "." + std::to_string(level)}, {"mesh", meshes_.size()}, {"skin", 0}});
      const Json primitive{{"attributes", attributes}, {"indices", indices[level]}, {"material", 0}};
      meshes_.push_back({{"primitives", Json::array({primitive})}});
      if (level == 0) continue;
      coarser_.push_back(node + level);
      lods.push_back({{"node", node + level}, {"error", made.levels[level].error}});
    }
    nodes_[node]["extras"] = {{"throng_part", extras_of(made, named.body)}};
    if (!lods.empty()) nodes_[node]["extras"]["throng_mesh_lods"] = lods;
  }

  void add_skin(Json& file) {
    std::vector<std::array<float, 16>> binds = mannequin::inverse_binds();
    for (auto& bind : binds) {
      for (const std::size_t diagonal : {0U, 5U, 10U}) bind[diagonal] = static_cast<float>(written_step);
    }
    Json joints = Json::array();
    for (std::size_t j = 0; j < mannequin::joint_count; ++j) joints.push_back(j);
    const std::size_t matrices =
        buffer_.add<std::array<float, 16>>(binds, "MAT4", ComponentType::float32, Target::none);
    file["skins"] =
        Json::array({{{"name", "wardrobe"}, {"inverseBindMatrices", matrices}, {"skeleton", 0}, {"joints", joints}}});
  }

  BufferWriter buffer_;
  Json nodes_, meshes_ = Json::array();
  std::vector<std::size_t> finest_, coarser_{0};  // the root of the joints belongs to every scene with a skin
  std::map<std::vector<Bytes4>, std::size_t> colours_;
};

}  // namespace

std::vector<std::byte> write_wardrobe(std::span<const Finished> parts) {
  WardrobeWriter writer;
  for (const Finished& part : parts) writer.add(part);
  return writer.finish();
}

std::vector<std::byte> make_wardrobe() {
  std::vector<Finished> parts = finish_wardrobe({}, true);
  for (Finished& silhouette : make_silhouettes(parts)) parts.push_back(std::move(silhouette));
  return write_wardrobe(parts);
}

}  // namespace throng::wardrobe
