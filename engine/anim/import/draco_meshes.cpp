#include "engine/anim/import/draco_meshes.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <draco/compression/decode.h>
#include <nlohmann/json.hpp>

#include "engine/anim/import/draco_header.h"
#include "engine/anim/import/json_document.h"
#include "engine/anim/import/refusal.h"

namespace throng::import {

namespace {

using nlohmann::json;
using Bytes = std::span<const std::byte>;

/// More than any encoder packs, even of a flat grid.
constexpr std::uint64_t most_faces_a_byte = 4096;

constexpr int triangles_mode = 4;
constexpr int unsigned_int = 5125;

/// The bytes of a component type of glTF, or 0 where a Draco attribute cannot have it.
std::size_t component_bytes(int component_type) {
  switch (component_type) {
    case 5120:
    case 5121:
      return 1;
    case 5122:
    case 5123:
      return 2;
    case unsigned_int:
    case 5126:
      return 4;
    default:
      return 0;
  }
}

int vector_width(const std::string& type) {
  if (type == "SCALAR") return 1;
  return type.starts_with("VEC") ? type[3] - '0' : 0;
}

bool convert(const draco::PointAttribute& attribute, draco::AttributeValueIndex value, int width, int component_type,
             std::byte* to) {
  const auto parts = static_cast<std::int8_t>(width);
  switch (component_type) {
    case 5120:
      return attribute.ConvertValue(value, parts, reinterpret_cast<std::int8_t*>(to));
    case 5121:
      return attribute.ConvertValue(value, parts, reinterpret_cast<std::uint8_t*>(to));
    case 5122:
      return attribute.ConvertValue(value, parts, reinterpret_cast<std::int16_t*>(to));
    case 5123:
      return attribute.ConvertValue(value, parts, reinterpret_cast<std::uint16_t*>(to));
    case unsigned_int:
      return attribute.ConvertValue(value, parts, reinterpret_cast<std::uint32_t*>(to));
    default:
      return attribute.ConvertValue(value, parts, reinterpret_cast<float*>(to));
  }
}

std::unique_ptr<draco::Mesh> decode(Bytes bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  auto mesh = draco::Decoder().DecodeMeshFromBuffer(&buffer);
  if (!mesh.ok()) throw Refusal(std::string("its Draco mesh does not decode: ") + mesh.status().error_msg());
  return std::move(mesh).value();
}

class DracoDecoder {
 public:
  DracoDecoder(json& document, BufferViews& views, std::vector<std::string>& repairs)
      : document_(document), views_(views), repairs_(repairs) {}

  void decode_primitive(json& primitive, const json& compressed) {
    if (!primitive.contains("indices")) throw Refusal("its Draco mesh has no indices");
    const Bytes bytes = views_.views[compressed["bufferView"].get<std::size_t>()];
    check_counts(bytes);
    const std::unique_ptr<draco::Mesh> mesh = decode(bytes);
    give_indices(primitive["indices"].get<std::size_t>(), *mesh);
    primitive["mode"] = triangles_mode;
    for (const auto& [semantic, id] : compressed["attributes"].items()) {
      const auto accessor = primitive["attributes"].find(semantic);
      if (accessor == primitive["attributes"].end()) throw Refusal(semantic + " is in its Draco mesh alone");
      const draco::PointAttribute* const attribute = mesh->GetAttributeByUniqueId(id.get<std::uint32_t>());
      if (attribute == nullptr) throw Refusal("its Draco mesh has no attribute " + id.dump() + " for " + semantic);
      give_attribute(accessor->get<std::size_t>(), *mesh, *attribute, semantic);
    }
  }

 private:
  static void check_counts(Bytes bytes) {
    const DracoCounts counts = read_draco_counts(bytes);
    if (counts.faces > bytes.size() * most_faces_a_byte || counts.points > counts.faces * 3) {
      throw Refusal(std::to_string(bytes.size()) + " bytes of Draco cannot hold " + std::to_string(counts.faces) +
                    " triangles");
    }
  }

  /// Makes a view of its own for an accessor, with room for `count` elements, and returns its bytes. Returns nothing
  /// for an accessor that has one.
  std::byte* give_view(std::size_t index, std::size_t count, std::size_t element_bytes) {
    json& accessor = document_["accessors"][index];
    if (!given_.insert(index).second) return nullptr;
    if (accessor["count"].get<std::uint64_t>() != count) {
      repairs_.push_back(json_label("accessor", index, accessor) + ": says " + accessor["count"].dump() +
                         " elements, but its Draco mesh has " + std::to_string(count) + ", all taken");
      accessor["count"] = count;
    }
    decoded_ += count * element_bytes;
    if (decoded_ > max_decompressed_size) throw Refusal("Draco meshes decode to more than 512 MiB");
    std::vector<std::byte>& bytes = views_.storage.emplace_back(count * element_bytes);
    accessor["bufferView"] = views_.views.size();
    accessor["byteOffset"] = 0;
    document_["bufferViews"].push_back({{"buffer", 0}, {"byteLength", bytes.size()}});
    views_.views.emplace_back(bytes);
    return bytes.data();
  }

  void give_indices(std::size_t index, const draco::Mesh& mesh) {
    std::byte* to = give_view(index, std::size_t{mesh.num_faces()} * 3, sizeof(std::uint32_t));
    if (to == nullptr) return;
    document_["accessors"][index]["componentType"] = unsigned_int;
    for (std::uint32_t face = 0; face < mesh.num_faces(); ++face) {
      for (const draco::PointIndex& point : mesh.face(draco::FaceIndex(face))) {
        const std::uint32_t value = point.value();
        std::memcpy(to, &value, sizeof value);
        to += sizeof value;
      }
    }
  }

  void give_attribute(std::size_t index, const draco::Mesh& mesh, const draco::PointAttribute& attribute,
                      const std::string& semantic) {
    const json& accessor = document_["accessors"][index];
    const int component_type = accessor["componentType"].get<int>();
    const int width = vector_width(accessor["type"].get<std::string>());
    const std::size_t element = static_cast<std::size_t>(width) * component_bytes(component_type);
    if (element == 0) throw Refusal(semantic + " has a type that no Draco mesh has");
    std::byte* to = give_view(index, mesh.num_points(), element);
    if (to == nullptr) return;
    for (std::uint32_t point = 0; point < mesh.num_points(); ++point) {
      const draco::AttributeValueIndex value = attribute.mapped_index(draco::PointIndex(point));
      if (!convert(attribute, value, width, component_type, to + point * element)) {
        throw Refusal(semantic + " of its Draco mesh does not fit its accessor");
      }
    }
  }

  json& document_;
  BufferViews& views_;
  std::vector<std::string>& repairs_;
  std::set<std::size_t> given_;  ///< accessors
  std::size_t decoded_ = 0;      ///< bytes
};

}  // namespace

void decode_draco_meshes(json& document, BufferViews& views, std::vector<std::string>& repairs) {
  if (!document.contains("meshes")) return;
  DracoDecoder decoder(document, views, repairs);
  std::size_t mesh_index = 0;
  for (json& mesh : document["meshes"]) {
    const std::string mesh_name = json_label("mesh", mesh_index++, mesh);
    std::size_t index = 0;
    for (json& primitive : mesh["primitives"]) {
      const std::string name = mesh_name + ", primitive " + std::to_string(index++);
      const auto extensions = primitive.find("extensions");
      if (extensions == primitive.end() || !extensions->contains("KHR_draco_mesh_compression")) continue;
      try {
        const json compressed = (*extensions)["KHR_draco_mesh_compression"];
        decoder.decode_primitive(primitive, compressed);
      } catch (const Refusal& refusal) {
        throw Refusal(name + ": " + refusal.what() + "; export the file again");
      }
    }
  }
}

}  // namespace throng::import
