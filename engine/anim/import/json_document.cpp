#include "engine/anim/import/json_document.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <nlohmann/json.hpp>

#include "engine/anim/import/bytes/refusal.h"
#include "engine/anim/import/json_extensions.h"
#include "engine/anim/import/source_file.h"
#include "engine/base/json/json_tree.h"
#include "engine/base/text/plain_text.h"

namespace throng::import {

namespace {

using nlohmann::json;

void keep_read_extensions(json& object) {
  const auto extensions = object.find("extensions");
  if (extensions == object.end()) return;
  if (!extensions->is_object()) throw Refusal("an \"extensions\" in its JSON is not an object; export the file again");
  json kept = json::object();
  for (const char* name : read_extensions) {
    if (const auto extension = extensions->find(name); extension != extensions->end()) {
      kept[name] = std::move(*extension);
    }
  }
  *extensions = std::move(kept);
}

/// Makes our property, among the extras of objects of `array`, a property of the object itself, so that it is checked
/// like all others. Other extras may be anything and are dropped later.
void keep_extra(json& document, const char* array, const char* property) {
  for (json& object : elements(document, array)) {
    if (!object.is_object()) continue;
    object.erase(property);
    const auto extras = object.find("extras");
    if (extras == object.end() || !extras->is_object() || !extras->contains(property)) continue;
    json kept = std::move((*extras)[property]);
    object[property] = std::move(kept);
  }
}

/// A part may be said by its slot alone, as programs write a custom property.
void spell_out_parts(json& document) {
  for (json& node : elements(document, "nodes")) {
    if (!node.is_object() || !node.contains(part_property)) continue;
    json& part = node[part_property];
    if (part.is_string()) part = json{{"slot", part}};
  }
}

/// A text has two bytes for each value at least, so its length limits them. Objects are searched by their keys.
constexpr JsonLimits gltf_limits{.depth = max_json_depth,
                                 .bytes = max_file_size,
                                 .values = std::numeric_limits<std::size_t>::max(),
                                 .members = std::numeric_limits<std::size_t>::max()};

/// Names from old exporters may be no UTF-8, which JSON demands.
json parse_text(std::string_view text, std::vector<std::string>& repairs) {
  auto document = parse_json_tree<json>(text, gltf_limits);
  if (!document && !is_utf8(text)) {
    document = parse_json_tree<json>(plain_text(text), gltf_limits);
    if (document) repairs.emplace_back("its JSON is no UTF-8: letters of names were replaced");
  }
  if (!document)
    throw Refusal("it is neither GLB nor valid JSON: its text " + document.error().message +
                  "; export it again as glTF 2.0");
  return std::move(*document);
}

/// Shortens a name that is too long to read. Many objects are made of one, and each has its name.
void shorten_name(std::string& name) {
  constexpr std::size_t longest = 1024;  // bytes
  if (name.size() <= longest) return;
  std::size_t size = longest;
  while (size > 0 && (static_cast<unsigned char>(name[size]) & 0xC0U) == 0x80U) --size;  // inside a letter
  name.resize(size);
  name.shrink_to_fit();
}

void simplify(json& value) {
  constexpr double largest_exact = 9007199254740992.0;  // 2^53
  if (value.is_number_float()) {
    const double number = value.get<double>();
    if (number == std::trunc(number) && std::abs(number) <= largest_exact) value = static_cast<std::int64_t>(number);
    return;
  }
  if (value.is_object()) {
    value.erase("extras");
    keep_read_extensions(value);
    if (const auto name = value.find("name"); name != value.end() && name->is_string()) {
      shorten_name(name->get_ref<std::string&>());
      *name = plain_text(name->get_ref<const std::string&>());
    }
  }
  if (value.is_structured()) {
    for (json& element : value) simplify(element);
  }
}

}  // namespace

nlohmann::json parse_json(std::string_view text, std::vector<std::string>& repairs) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  while (!text.empty() && text.back() == '\0') text.remove_suffix(1);
  json document = parse_text(text, repairs);
  if (!document.is_object()) throw Refusal("its JSON is not an object; export the file again as glTF 2.0");
  if (std::ranges::none_of(std::array{"asset", "scenes", "nodes", "meshes", "buffers"},
                           [&](const char* key) { return document.contains(key); })) {
    throw Refusal("it is JSON, but not glTF, which says its version in \"asset\"; name a .glb or .gltf");
  }
  leave_out_unknown_values(document, repairs);
  keep_extra(document, "animations", data_keys_property);
  keep_extra(document, "animations", curves_property);
  keep_extra(document, "nodes", mesh_lods_property);
  keep_extra(document, "nodes", part_property);
  spell_out_parts(document);
  keep_extra(document, "meshes", target_names_property);
  simplify(document);
  return document;
}

const json& array_of(const json& object, const char* key) {
  static const json none = json::array();
  const auto found = object.find(key);
  return found == object.end() ? none : *found;
}

json* find_property(json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

std::span<json> elements(json& object, const char* key) {
  json* const found = find_property(object, key);
  if (found == nullptr || !found->is_array()) return {};
  return found->get_ref<json::array_t&>();
}

std::string shown_name(const std::string& name) {
  constexpr std::size_t longest = 120;  // bytes; messages repeat a name many times
  return name.size() <= longest ? name : name.substr(0, longest) + "...";
}

std::string json_label(const std::string& type, std::size_t index, const nlohmann::json& object) {
  std::string text = type + " " + std::to_string(index);
  if (!object.is_object()) return text;
  const auto name = object.find("name");
  if (name == object.end() || !name->is_string() || name->get_ref<const std::string&>().empty()) return text;
  return text.append(" \"").append(shown_name(name->get_ref<const std::string&>())).append("\"");
}

}  // namespace throng::import
