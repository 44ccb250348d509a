#include "engine/anim/import/document.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "engine/anim/base/plain_text.h"
#include "engine/anim/import/accessors.h"
#include "engine/anim/import/draco_meshes.h"
#include "engine/anim/import/json_document.h"
#include "engine/anim/import/json_extensions.h"
#include "engine/anim/import/json_repairs.h"
#include "engine/anim/import/refusal.h"
#include "engine/anim/import/source_file.h"

namespace throng::import {

namespace {

using nlohmann::json;
using namespace nlohmann::literals;

std::vector<ImageSource> take_images(json& document) {
  std::vector<ImageSource> images;
  for (const json& image : document.value("images", json::array())) {
    images.push_back({.buffer_view = image.value("bufferView", -1), .uri = image.value("uri", std::string())});
  }
  document.erase("images");
  return images;
}

std::vector<std::vector<anim::NamedDataKey>> take_data_keys(json& document) {
  std::vector<std::vector<anim::NamedDataKey>> animations;
  if (!document.contains("animations")) return animations;
  for (json& animation : document["animations"]) {
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
  if (!document.contains("animations")) return animations;
  for (json& animation : document["animations"]) {
    std::vector<anim::NamedCurve>& curves = animations.emplace_back();
    const json named = animation.value(curves_property, json::object());
    for (auto curve = named.begin(); curve != named.end(); ++curve) {
      curves.push_back({.name = anim::plain_text(curve.key()),
                        .times = curve.value()["times"].get<std::vector<float>>(),
                        .values = curve.value()["values"].get<std::vector<float>>()});
    }
    animation.erase(curves_property);
  }
  return animations;
}

std::vector<std::vector<MeshLodNode>> take_mesh_lods(json& document) {
  std::vector<std::vector<MeshLodNode>> nodes;
  if (!document.contains("nodes")) return nodes;
  for (json& node : document["nodes"]) {
    std::vector<MeshLodNode>& lods = nodes.emplace_back();
    for (const json& lod : node.value(mesh_lods_property, json::array())) {
      lods.push_back({.node = lod["node"].get<int>(), .error = lod["error"].get<double>()});
    }
    node.erase(mesh_lods_property);
  }
  return nodes;
}

/// Extras may hold anything; what is no list of names is none.
std::vector<std::vector<std::string>> take_target_names(json& document) {
  std::vector<std::vector<std::string>> meshes;
  for (const json& mesh : document.value("meshes", json::array())) {
    std::vector<std::string>& names = meshes.emplace_back();
    const auto listed = mesh.find(target_names_property);
    if (listed == mesh.end() || !listed->is_array()) continue;
    for (const json& name : *listed) names.push_back(name.is_string() ? anim::plain_text(name.get<std::string>()) : "");
  }
  return meshes;
}

std::vector<bool> take_hidden(json& document) {
  std::vector<bool> hidden;
  if (!document.contains("nodes")) return hidden;
  for (json& node : document["nodes"]) {
    const json visibility = node.value("/extensions/KHR_node_visibility"_json_pointer, json::object());
    hidden.push_back(!visibility.value("visible", true));
    node.erase("extensions");
  }
  return hidden;
}

bool refuse_to_load(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return false;
}

/// Maps JSON to tinygltf's structs and nothing else: `document` has no buffer or image left that it could open.
tinygltf::Model map_document(const json& document) {
  const std::string text = document.dump();
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

}  // namespace

Document load_document(const std::filesystem::path& path, bool strict) {
  Document document;
  document.file = read_file(path);
  const FileParts parts = split_file(document.file, path);
  json json_document = parse_json(parts.json, document.repairs);
  check_json(json_document);
  check_required_extensions(json_document, document.repairs);
  repair_json(json_document, document.repairs);

  document.files = ModelFiles(path, strict);
  document.images = take_images(json_document);
  document.data_keys = take_data_keys(json_document);
  document.curves = take_curves(json_document);
  document.mesh_lods = take_mesh_lods(json_document);
  document.target_names = take_target_names(json_document);
  document.is_hidden = take_hidden(json_document);
  document.humanoid = read_humanoid(json_document, document.repairs);
  document.buffer_views = load_buffer_views(json_document, parts.binary, document.files, document.repairs);
  decode_draco_meshes(json_document, document.buffer_views, document.repairs);
  for (const char* key : {"buffers", "cameras", "extensions", "extensionsUsed", "extensionsRequired"}) {
    json_document.erase(key);
  }
  document.gltf = map_document(json_document);
  check_accessors(document);
  return document;
}

std::string label(const std::string& type, std::size_t index, const std::string& name) {
  const std::string text = type + " " + std::to_string(index);
  return name.empty() ? text : text + " \"" + name + "\"";
}

}  // namespace throng::import
