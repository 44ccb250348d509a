#include "app/people/place/props.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "app/files/data_folder.h"
#include "engine/base/files/input_file.h"
#include "engine/base/json/json.h"

namespace throng::app {
namespace {

using render::SceneryMeshData;
using render::SceneryVertex;

/// Why the file is no file of props.
struct Damage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct PropFile {
  Json json;
  std::string buffer;
};

template <typename Value>
Value member(const Json& object, std::string_view key) {
  if (!object[key].is<Value>()) throw Damage("its description lacks \"" + std::string(key) + "\"");
  return object[key].get<Value>();
}

const Json& element_at(const Json& array, std::size_t i) {
  if (i >= array.elements().size()) throw Damage("its description names what is not there");
  return array.elements()[i];
}

template <typename Value>
Value value_at(const std::string& bytes, std::size_t offset) {
  if (offset > bytes.size() || bytes.size() - offset < sizeof(Value)) throw Damage("it ends too early");
  Value value;
  std::memcpy(&value, bytes.data() + offset, sizeof(Value));
  return value;
}

std::string chunk(const std::string& bytes, std::size_t offset, std::uint32_t type) {
  const auto size = value_at<std::uint32_t>(bytes, offset);
  if (value_at<std::uint32_t>(bytes, offset + 4) != type) throw Damage("it is no binary glTF 2.0 file");
  if (bytes.size() - offset - 8 < size) throw Damage("it ends too early");
  return bytes.substr(offset + 8, size);
}

PropFile parse(const std::string& bytes) {
  constexpr std::uint32_t magic = 0x46546C67, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
  if (value_at<std::uint32_t>(bytes, 0) != magic) throw Damage("it is no binary glTF 2.0 file");
  const std::string text = chunk(bytes, 12, json_chunk);
  auto json = parse_json(text);
  if (!json) throw Damage(json.error().message);
  return {std::move(*json), chunk(bytes, 20 + text.size(), binary_chunk)};
}

/// The bytes of an accessor's elements.
struct Elements {
  std::size_t offset, stride, count;
};

Elements elements_of(const PropFile& file, std::size_t accessor, std::size_t size, int component) {
  const Json& described = element_at(file.json["accessors"], accessor);
  const Json& view = element_at(file.json["bufferViews"], member<std::size_t>(described, "bufferView"));
  if (member<int>(described, "componentType") != component) throw Damage("an accessor has another type than expected");
  const Elements found{member<std::size_t>(view, "byteOffset") + described.value("byteOffset", std::size_t{0}),
                       view.value("byteStride", size), member<std::size_t>(described, "count")};
  const std::size_t room = file.buffer.size();
  const bool inside = found.stride >= size && found.count > 0 && found.offset <= room &&
                      found.count <= (room - found.offset + found.stride - size) / found.stride;
  if (!inside) throw Damage("an accessor leaves the buffer");
  return found;
}

template <typename Value, std::size_t N>
std::array<Value, N> element(const PropFile& file, const Elements& elements, std::size_t i) {
  return value_at<std::array<Value, N>>(file.buffer, elements.offset + i * elements.stride);
}

constexpr int byte_type = 5120, unsigned_byte_type = 5121, short_type = 5122, unsigned_short_type = 5123;

std::vector<SceneryVertex> read_vertices(const PropFile& file, const Json& attributes, float step) {
  const Elements positions = elements_of(file, member<std::size_t>(attributes, "POSITION"), 6, short_type);
  const Elements normals = elements_of(file, member<std::size_t>(attributes, "NORMAL"), 3, byte_type);
  const Elements colors = elements_of(file, member<std::size_t>(attributes, "COLOR_0"), 4, unsigned_byte_type);
  const Elements surfaces = elements_of(file, member<std::size_t>(attributes, "_SURFACE"), 4, unsigned_byte_type);
  if (normals.count != positions.count || colors.count != positions.count || surfaces.count != positions.count) {
    throw Damage("a mesh has fewer of one attribute than of another");
  }
  std::vector<SceneryVertex> vertices(positions.count);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    SceneryVertex& vertex = vertices[i];
    const auto position = element<std::int16_t, 3>(file, positions, i);
    const auto normal = element<std::int8_t, 3>(file, normals, i);
    const auto surface = element<std::uint8_t, 4>(file, surfaces, i);
    const glm::vec3 direction(normal[0], normal[1], normal[2]);
    const float length = glm::length(direction);
    if (length < 64.0F) throw Damage("a mesh has a corner without a normal");
    if (surface[3] > static_cast<std::uint8_t>(render::SceneryKind::metal))
      throw Damage("a mesh has an unknown surface");
    for (int axis = 0; axis < 3; ++axis) {
      vertex.position[axis] = static_cast<float>(position[static_cast<std::size_t>(axis)]) * step;
      vertex.normal[axis] = direction[axis] / length;
    }
    const auto color = element<std::uint8_t, 4>(file, colors, i);
    std::memcpy(vertex.color, color.data(), color.size());
    vertex.glow = surface[0];
    vertex.tinted = surface[1];
    vertex.sway = surface[2];
    vertex.kind = static_cast<render::SceneryKind>(surface[3]);
  }
  return vertices;
}

render::SceneryLodData read_lod(const PropFile& file, const Json& mesh, std::size_t vertex_count) {
  const Json& primitive = element_at(mesh["primitives"], 0);
  const Elements elements = elements_of(file, member<std::size_t>(primitive, "indices"), 2, unsigned_short_type);
  if (elements.count % 3 != 0) throw Damage("a mesh has a part of a triangle");
  render::SceneryLodData lod;
  lod.error = member<float>(mesh["extras"], "error");
  lod.indices.reserve(elements.count);
  for (std::size_t i = 0; i < elements.count; ++i) {
    lod.indices.push_back(element<std::uint16_t, 1>(file, elements, i)[0]);
    if (lod.indices.back() >= vertex_count) throw Damage("a triangle has a corner that is not there");
  }
  return lod;
}

/// Meshes stand in the file with their coarser levels behind them: NAME, NAME.1, NAME.2.
std::vector<SceneryMeshData> read_meshes(const PropFile& file) {
  std::vector<SceneryMeshData> props;
  for (const Json& node : file.json["nodes"].elements()) {
    const Json& mesh = element_at(file.json["meshes"], member<std::size_t>(node, "mesh"));
    const auto name = member<std::string>(mesh, "name");
    const bool coarser = !props.empty() && name == props.back().name + "." + std::to_string(props.back().lods.size());
    if (!coarser) {
      const Json& step = element_at(node["scale"], 0);
      if (!step.is<float>()) throw Damage("a node has no scale");
      const Json& attributes = element_at(mesh["primitives"], 0)["attributes"];
      props.push_back({name, read_vertices(file, attributes, step.get<float>()), {}});
    }
    props.back().lods.push_back(read_lod(file, mesh, props.back().vertices.size()));
  }
  if (props.empty()) throw Damage("it has no mesh");
  return props;
}

}  // namespace

Result<std::vector<SceneryMeshData>> read_props(const std::filesystem::path& file) {
  constexpr std::size_t most_bytes = std::size_t{64} << 20U;
  const auto bytes = read_text(file, "the file of props", most_bytes);
  if (!bytes) return Error{file.string() + ": " + bytes.error().message};
  try {
    return read_meshes(parse(*bytes));
  } catch (const Damage& damage) {
    return Error{file.string() + ": the file of props is damaged: " + damage.what() + "; install it anew"};
  }
}

Result<std::vector<SceneryMeshData>> load_props(const std::string& data_option) {
  const auto file = find_data(data_folders(data_option), "assets/places.glb");
  if (!file) return file.error();
  return read_props(*file);
}

}  // namespace throng::app
