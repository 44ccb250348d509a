#include "engine/anim/import/document.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "engine/anim/import/accessors.h"
#include "engine/anim/import/bytes/refusal.h"
#include "engine/anim/import/draco_meshes.h"
#include "engine/anim/import/json_document.h"
#include "engine/anim/import/json_extensions.h"
#include "engine/anim/import/json_repairs.h"
#include "engine/anim/import/memory/json_memory.h"
#include "engine/anim/import/source_file.h"
#include "engine/base/text/plain_text.h"

namespace throng::import {

namespace {

using nlohmann::json;
using namespace nlohmann::literals;

/// Moves the uris, because one may hold the whole image.
std::vector<ImageSource> take_images(json& document) {
  std::vector<ImageSource> images;
  for (json& image : elements(document, "images")) {
    ImageSource& source = images.emplace_back();
    source.buffer_view = image.value("bufferView", -1);
    source.name = image.value("name", std::string());
    if (const auto uri = image.find("uri"); uri != image.end()) source.uri = std::move(uri->get_ref<std::string&>());
  }
  document.erase("images");
  return images;
}

std::vector<std::vector<anim::NamedDataKey>> take_data_keys(json& document) {
  std::vector<std::vector<anim::NamedDataKey>> animations;
  for (json& animation : elements(document, "animations")) {
    std::vector<anim::NamedDataKey>& keys = animations.emplace_back();
    for (const json& key : animation.value(data_keys_property, json::array())) {
      keys.push_back({.time = key["time"].get<double>(), .name = key["name"].get<std::string>()});
    }
    animation.erase(data_keys_property);
  }
  return animations;
}

std::vector<std::vector<anim::NamedCurve>> take_curves(json& document) {
  std::vector<std::vector<anim::NamedCurve>> animations;
  for (json& animation : elements(document, "animations")) {
    std::vector<anim::NamedCurve>& curves = animations.emplace_back();
    const json named = animation.value(curves_property, json::object());
    for (auto curve = named.begin(); curve != named.end(); ++curve) {
      curves.push_back({.name = plain_text(curve.key()),
                        .times = curve.value()["times"].get<std::vector<float>>(),
                        .values = curve.value()["values"].get<std::vector<float>>()});
    }
    animation.erase(curves_property);
  }
  return animations;
}

std::vector<std::vector<MeshLodNode>> take_mesh_lods(json& document) {
  std::vector<std::vector<MeshLodNode>> nodes;
  for (json& node : elements(document, "nodes")) {
    std::vector<MeshLodNode>& lods = nodes.emplace_back();
    for (const json& lod : node.value(mesh_lods_property, json::array())) {
      lods.push_back({.node = lod["node"].get<int>(), .error = lod["error"].get<double>()});
    }
    node.erase(mesh_lods_property);
  }
  return nodes;
}

std::vector<std::string> plain_texts(const json& texts) {
  std::vector<std::string> plain;
  for (const json& text : texts) plain.push_back(plain_text(text.get<std::string>()));
  return plain;
}

std::map<int, PartNode> take_parts(json& document) {
  std::map<int, PartNode> parts;
  int index = -1;
  for (json& node : elements(document, "nodes")) {
    ++index;
    const auto said = node.find(part_property);
    if (said == node.end()) continue;
    parts[index] = {.slot = plain_text((*said)["slot"].get<std::string>()),
                    .body = plain_text(said->value("body", "")),
                    .covers = plain_texts(said->value("covers", json::array())),
                    .keeps_out = plain_texts(said->value("keeps_out", json::array())),
                    .tags = plain_texts(said->value("tags", json::array())),
                    .error = said->value("error", 0.0)};
    node.erase(part_property);
  }
  return parts;
}

/// Extras may hold anything; what is no list of names is none.
std::vector<std::vector<std::string>> take_target_names(json& document) {
  std::vector<std::vector<std::string>> meshes;
  for (const json& mesh : array_of(document, "meshes")) {
    std::vector<std::string>& names = meshes.emplace_back();
    const auto listed = mesh.find(target_names_property);
    if (listed == mesh.end() || !listed->is_array()) continue;
    for (const json& name : *listed) names.push_back(name.is_string() ? plain_text(name.get<std::string>()) : "");
  }
  return meshes;
}

std::vector<bool> take_hidden(json& document) {
  std::vector<bool> hidden;
  for (json& node : elements(document, "nodes")) {
    const json visibility = node.value("/extensions/KHR_node_visibility"_json_pointer, json::object());
    hidden.push_back(!visibility.value("visible", true));
    node.erase("extensions");
  }
  return hidden;
}

bool refuse_to_load(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return false;
}

/// Sums up what tinygltf's form of the objects takes, and ours of the nodes.
class MappedSize {
 public:
  explicit MappedSize(const json& document) {
    using namespace tinygltf;
    add(array_of(document, "nodes").size(), sizeof(Node) + bytes_in_a_tree);
    add(array_of(document, "accessors").size(), sizeof(Accessor));
    add(array_of(document, "bufferViews").size(), sizeof(BufferView));
    add(array_of(document, "materials").size(), sizeof(Material));
    add(array_of(document, "textures").size(), sizeof(tinygltf::Texture));
    add(array_of(document, "samplers").size(), sizeof(Sampler));
    add(array_of(document, "skins").size(), sizeof(Skin));
    add(array_of(document, "scenes").size(), sizeof(Scene));
    for (const json& mesh : array_of(document, "meshes")) {
      add(1, sizeof(Mesh));
      for (const json& primitive : array_of(mesh, "primitives")) {
        add(1 + array_of(primitive, "targets").size(), sizeof(Primitive));
      }
    }
    for (const json& animation : array_of(document, "animations")) {
      add(1, sizeof(tinygltf::Animation));
      add(array_of(animation, "channels").size(), sizeof(AnimationChannel));
      add(array_of(animation, "samplers").size(), sizeof(AnimationSampler));
    }
  }

  std::uint64_t bytes() const { return bytes_; }

 private:
  static constexpr std::size_t bytes_in_a_tree = 512;  // of a node, in NodeTree and in what finds bones

  void add(std::size_t count, std::size_t size) { bytes_ += std::uint64_t{count} * size; }

  std::uint64_t bytes_ = 0;
};

/// Charges what mapping takes: the text, a tree of it, and objects in vectors that grow. Returns what of it stays.
std::uint64_t charge_mapping(const MappedSize& size, std::string_view text, MemoryAccount& memory) {
  const std::uint64_t tree = parsed_json_memory(text), free = memory.json_allowance(text.size());
  const std::uint64_t needed = text.size() * 3 + tree + size.bytes() * 3, kept = size.bytes() * 2;
  memory.charge(needed - std::min(needed, free), "its JSON");
  return kept - std::min(kept, free);
}

/// Maps JSON to tinygltf's structs and nothing else: `document` has no buffer or image left that it could open.
tinygltf::Model map_document(json document, MemoryAccount& memory) {
  MemoryScope scope(memory);
  const std::string text = document.dump();
  scope.keep(charge_mapping(MappedSize(document), text, memory));
  document = nullptr;
  tinygltf::TinyGLTF mapper;
  mapper.SetImageLoader(&refuse_to_load, nullptr);
  mapper.SetFsCallbacks({});
  tinygltf::Model model;
  std::string error;
  std::string warning;
  const auto length = static_cast<unsigned int>(text.size());
  if (!mapper.LoadASCIIFromString(&model, &error, &warning, text.data(), length, "")) {
    std::ranges::replace(error, '\n', ' ');
    throw Refusal("tinygltf finds: " + error + "; export the file again");
  }
  return model;
}

/// Charges what a tree of the text takes beyond its allowance.
void charge_json(std::string_view text, MemoryAccount& memory) {
  const std::uint64_t tree = parsed_json_memory(text);
  memory.charge(tree - std::min(tree, memory.json_allowance(text.size())), "its JSON");
}

std::vector<std::byte> read_model(const ModelSource& source, MemoryAccount& memory) {
  if (!source.files.empty()) {
    const std::span<const std::byte> bytes = source.files.front().bytes;
    memory.add_file(bytes.size(), "the file");
    return {bytes.begin(), bytes.end()};
  }
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(source.path, error);
  if (!error) memory.add_file(size, "the file");
  return read_file(source.path);
}

}  // namespace

Document load_document(const ModelSource& source, MemoryAccount& memory) {
  Document document;
  document.memory = &memory;
  document.file = read_model(source, memory);
  const FileParts parts = split_file(document.file, source.path);
  const std::uint64_t before = memory.held();
  charge_json(parts.json, memory);
  const std::uint64_t tree = memory.held() - before;
  json json_document = parse_json(parts.json, document.repairs);
  if (!parts.binary) {
    memory.release(document.file.size());
    document.file = std::vector<std::byte>();
  }
  check_json(json_document);
  check_required_extensions(json_document, document.repairs);
  repair_json(json_document, document.repairs);

  document.files = ModelFiles(source);
  document.images = take_images(json_document);
  document.data_keys = take_data_keys(json_document);
  document.curves = take_curves(json_document);
  document.mesh_lods = take_mesh_lods(json_document);
  document.parts = take_parts(json_document);
  document.target_names = take_target_names(json_document);
  document.is_hidden = take_hidden(json_document);
  document.humanoid = read_humanoid(json_document, document.repairs);
  document.buffer_views = load_buffer_views(json_document, parts.binary, document.files, document.repairs, memory);
  decode_draco_meshes(json_document, document.buffer_views, document.repairs, memory);
  for (const char* key : {"buffers", "cameras", "extensions", "extensionsUsed", "extensionsRequired"}) {
    json_document.erase(key);
  }
  memory.release(tree);
  document.gltf = map_document(std::move(json_document), memory);
  check_accessors(document);
  return document;
}

void Document::charge_repairs() {
  constexpr std::uint64_t copies = 2, a_text = 3 * sizeof(std::string);  // in a vector that grows
  for (; charged_repairs < repairs.size(); ++charged_repairs) {
    memory->charge_for_good(copies * (repairs[charged_repairs].size() + a_text), "the list of repairs");
  }
}

std::string label(const std::string& type, std::size_t index, const std::string& name) {
  const std::string text = type + " " + std::to_string(index);
  return name.empty() ? text : text + " \"" + shown_name(name) + "\"";
}

}  // namespace throng::import
