#include "engine/anim/import/draco_meshes.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <set>
#include <span>

#include <draco/compression/config/decoder_options.h>
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <nlohmann/json.hpp>

#include "engine/anim/import/accessors.h"
#include "engine/anim/import/bytes/draco_header.h"
#include "engine/anim/import/bytes/refusal.h"
#include "engine/anim/import/json_document.h"

namespace throng::import {

namespace {

using nlohmann::json;
using Bytes = std::span<const std::byte>;

/// More than any encoder packs, even of a flat grid.
constexpr std::uint64_t most_faces_a_byte = 4096;

int vector_width(const std::string& type) {
  if (type == "SCALAR") return 1;
  return type.starts_with("VEC") ? type[3] - '0' : 0;
}

bool convert(const draco::PointAttribute& attribute, draco::AttributeValueIndex value, int width, int component_type,
             std::byte* to) {
  const auto parts = static_cast<std::int8_t>(width);
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return attribute.ConvertValue(value, parts, reinterpret_cast<std::int8_t*>(to));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return attribute.ConvertValue(value, parts, reinterpret_cast<std::uint8_t*>(to));
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return attribute.ConvertValue(value, parts, reinterpret_cast<std::int16_t*>(to));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return attribute.ConvertValue(value, parts, reinterpret_cast<std::uint16_t*>(to));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return attribute.ConvertValue(value, parts, reinterpret_cast<std::uint32_t*>(to));
    default:
      return attribute.ConvertValue(value, parts, reinterpret_cast<float*>(to));
  }
}

/// Charges the account with the attributes of a mesh, which it has when its triangles are known, before they are read.
template <typename Decoder>
class CountingDecoder final : public Decoder {
 public:
  CountingDecoder(MemoryAccount& memory, const std::string& name) : memory_(memory), name_(name) {}

 private:
  bool DecodeAllAttributes() override {
    const draco::PointCloud& cloud = *this->point_cloud();
    for (std::int32_t i = 0; i < cloud.num_attributes(); ++i) {
      const draco::PointAttribute& attribute = *cloud.attribute(i);
      const std::uint64_t integers = std::uint64_t{static_cast<std::uint8_t>(attribute.num_components())} * 4;
      const auto stride = static_cast<std::uint64_t>(attribute.byte_stride());
      memory_.charge((integers + stride + bytes_a_place) * cloud.num_points(), name_);
    }
    return Decoder::DecodeAllAttributes();
  }

  static constexpr std::uint64_t bytes_a_place = 8;  // which value a point has, and the order in which they come

  MemoryAccount& memory_;
  const std::string& name_;
};

template <typename Decoder>
draco::Status decode_by(draco::DecoderBuffer& buffer, draco::Mesh& mesh, MemoryAccount& memory,
                        const std::string& name) {
  CountingDecoder<Decoder> decoder(memory, name);
  return decoder.Decode(draco::DecoderOptions(), &buffer, &mesh);
}

std::unique_ptr<draco::Mesh> decode(Bytes bytes, MemoryAccount& memory, const std::string& name) {
  draco::DecoderBuffer buffer, head_buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  head_buffer = buffer;
  draco::DracoHeader head;
  draco::Status status = draco::PointCloudDecoder::DecodeHeader(&head_buffer, &head);
  auto mesh = std::make_unique<draco::Mesh>();
  if (status.ok()) {
    status = head.encoder_method == draco::MESH_EDGEBREAKER_ENCODING
                 ? decode_by<draco::MeshEdgebreakerDecoder>(buffer, *mesh, memory, name)
                 : decode_by<draco::MeshSequentialDecoder>(buffer, *mesh, memory, name);
  }
  if (!status.ok()) throw Refusal(std::string("its Draco mesh does not decode: ") + status.error_msg());
  return mesh;
}

class DracoDecoder {
 public:
  DracoDecoder(json& document, BufferViews& views, std::vector<std::string>& repairs, MemoryAccount& memory)
      : document_(document), views_(views), repairs_(repairs), memory_(memory) {}

  void decode_primitive(json& primitive, const json& compressed, const std::string& name) {
    MemoryScope scope(memory_);
    kept_ = 0;
    name_ = name;
    if (!primitive.contains("indices")) throw Refusal("its Draco mesh has no indices");
    const Bytes bytes = views_.views[compressed["bufferView"].get<std::size_t>()];
    charge_triangles(bytes);
    const std::unique_ptr<draco::Mesh> mesh = decode(bytes, memory_, name_);
    give_indices(primitive["indices"].get<std::size_t>(), *mesh);
    primitive["mode"] = TINYGLTF_MODE_TRIANGLES;
    for (const auto& [semantic, id] : compressed["attributes"].items()) {
      const auto accessor = primitive["attributes"].find(semantic);
      if (accessor == primitive["attributes"].end()) throw Refusal(semantic + " is in its Draco mesh alone");
      const draco::PointAttribute* const attribute = mesh->GetAttributeByUniqueId(id.get<std::uint32_t>());
      if (attribute == nullptr) throw Refusal("its Draco mesh has no attribute " + id.dump() + " for " + semantic);
      give_attribute(accessor->get<std::size_t>(), *mesh, *attribute, semantic);
    }
    scope.keep(kept_);
  }

 private:
  void charge_triangles(Bytes bytes) {
    constexpr std::uint64_t bytes_a_face_and_seam = 28, bytes_a_point = 16;
    const DracoCounts counts = read_draco_counts(bytes);
    if (counts.faces > bytes.size() * most_faces_a_byte || counts.points > counts.faces * 3) {
      throw Refusal(std::to_string(bytes.size()) + " bytes of Draco cannot hold " + std::to_string(counts.faces) +
                    " triangles");
    }
    const std::uint64_t bytes_a_face = counts.by_valence ? 80 : 56;
    memory_.charge(counts.faces * (bytes_a_face + bytes_a_face_and_seam * counts.seams) + counts.points * bytes_a_point,
                   name_);
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
    memory_.charge(count * element_bytes, name_);
    kept_ += count * element_bytes;
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
    document_["accessors"][index]["componentType"] = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
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
    const std::size_t element = static_cast<std::size_t>(width) * component_size(component_type);
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
  MemoryAccount& memory_;
  std::set<std::size_t> given_;  ///< accessors
  std::string name_;             ///< of the primitive
  std::uint64_t kept_ = 0;       ///< bytes of its views
};

}  // namespace

void decode_draco_meshes(json& document, BufferViews& views, std::vector<std::string>& repairs, MemoryAccount& memory) {
  DracoDecoder decoder(document, views, repairs, memory);
  std::size_t mesh_index = 0;
  for (json& mesh : elements(document, "meshes")) {
    const std::string mesh_name = json_label("mesh", mesh_index++, mesh);
    std::size_t index = 0;
    for (json& primitive : elements(mesh, "primitives")) {
      const std::string name = mesh_name + ", primitive " + std::to_string(index++);
      const auto extensions = primitive.find("extensions");
      if (extensions == primitive.end() || !extensions->contains("KHR_draco_mesh_compression")) continue;
      try {
        const json compressed = (*extensions)["KHR_draco_mesh_compression"];
        decoder.decode_primitive(primitive, compressed, name);
      } catch (const Refusal& refusal) {
        throw Refusal(name + ": " + refusal.what() + "; export the file again");
      }
    }
  }
}

}  // namespace throng::import
