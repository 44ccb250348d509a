#include "engine/anim/import/json_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_set>

#include <nlohmann/json.hpp>

#include "engine/anim/import/json_schema.h"
#include "engine/anim/import/refusal.h"

namespace throng::import {

namespace {

using nlohmann::json;

// Extensions that a file may require because they do not change what we draw, or because we decode them.
constexpr std::array<std::string_view, 7> known_extensions{
    "KHR_texture_transform",  "KHR_mesh_quantization",           "EXT_meshopt_compression", "KHR_materials_unlit",
    "KHR_materials_specular", "KHR_materials_emissive_strength", "KHR_lights_punctual"};

/// A place in the document, as a frame of the descent, so that names are built only where something is wrong.
struct Place {
  const Place* outer = nullptr;
  std::string_view type;
  const json* object = nullptr;
  std::ptrdiff_t index = -1;
};

std::string describe(const Place& place) {
  if (place.outer == nullptr) return "the document";
  std::string text;
  if (place.outer->outer != nullptr) text.append(describe(*place.outer)).append(", ");
  text.append(place.type);
  if (place.index >= 0) text.append(" ").append(std::to_string(place.index));
  const auto name = place.object->is_object() ? place.object->find("name") : place.object->end();
  if (place.object->is_object() && name != place.object->end() && name->is_string()) {
    text.append(" \"").append(name->get_ref<const std::string&>()).append("\"");
  }
  return text;
}

[[noreturn]] void refuse(const Place& place, std::string_view key, const std::string& what) {
  throw Refusal(describe(place) + ": \"" + std::string(key) + "\" " + what + "; export the file again");
}

bool lists(std::string_view choices, std::string_view text) {
  while (!choices.empty()) {
    const std::string_view choice = choices.substr(0, choices.find('|'));
    if (choice == text) return true;
    choices.remove_prefix(std::min(choices.size(), choice.size() + 1));
  }
  return false;
}

class Checker {
 public:
  explicit Checker(const json& document) : document_(document) {}

  void check_object(const Place& place) const {
    for (const Property& property : gltf_schema()) {
      if (property.owner != place.type) continue;
      if (property.key == "*") {
        for (const auto& [key, value] : place.object->items()) check_value(place, key, property, value);
        continue;
      }
      const auto found = place.object->find(property.key);
      if (found != place.object->end()) {
        check_value(place, property.key, property, *found);
      } else if (property.required) {
        refuse(place, property.key, "is missing");
      }
    }
  }

 private:
  void check_value(const Place& place, std::string_view key, const Property& property, const json& value) const {
    switch (property.kind) {
      case Kind::flag:
        if (!value.is_boolean()) refuse(place, key, "is neither true nor false");
        break;
      case Kind::integer:
        if (!is_count(value)) refuse(place, key, "is not a whole number of at least 0");
        break;
      case Kind::number:
        if (!value.is_number() || !std::isfinite(value.get<double>())) refuse(place, key, "is not a number");
        break;
      case Kind::text:
        if (!value.is_string()) refuse(place, key, "is not a text");
        break;
      case Kind::choice:
        if (!value.is_string() || !lists(property.target, value.get_ref<const std::string&>())) {
          refuse(place, key, "is none of " + std::string(property.target));
        }
        break;
      case Kind::index:
        check_index(place, key, property, value);
        break;
      case Kind::object:
        if (!value.is_object()) refuse(place, key, "is not an object");
        check_object({.outer = &place, .type = property.target, .object = &value});
        break;
      case Kind::numbers:
      case Kind::texts:
      case Kind::indices:
      case Kind::objects:
        check_array(place, key, property, value);
        break;
    }
  }

  void check_array(const Place& place, std::string_view key, const Property& property, const json& value) const {
    if (!value.is_array()) refuse(place, key, "is not an array");
    const auto count = static_cast<std::size_t>(property.count);
    if (property.kind == Kind::numbers && count != 0 && value.size() != count) {
      refuse(place, key, "has " + std::to_string(value.size()) + " numbers, not " + std::to_string(count));
    }
    if (value.size() < count) refuse(place, key, "is empty");
    std::unordered_set<std::int64_t> seen;
    std::ptrdiff_t index = 0;
    for (const json& element : value) {
      if (property.kind == Kind::objects) {
        if (!element.is_object()) refuse(place, key, "holds what is not an object");
        check_object({.outer = &place, .type = property.target, .object = &element, .index = index});
      } else {
        Property single = property;
        single.kind = element_kind(property.kind);
        check_value(place, key, single, element);
        if (property.kind == Kind::indices && !seen.insert(element.get<std::int64_t>()).second) {
          refuse(place, key, "names " + element.dump() + " twice");
        }
      }
      ++index;
    }
  }

  static Kind element_kind(Kind array) {
    if (array == Kind::numbers) return Kind::number;
    return array == Kind::texts ? Kind::text : Kind::index;
  }

  static bool is_count(const json& value) {
    return value.is_number_integer() && (value.is_number_unsigned() || value.get<std::int64_t>() >= 0);
  }

  void check_index(const Place& place, std::string_view key, const Property& property, const json& value) const {
    if (!is_count(value)) refuse(place, key, "is " + value.dump() + ", which is no index");
    const auto array = document_.find(property.target);
    const std::size_t size = array == document_.end() ? 0 : array->size();
    if (value.get<std::uint64_t>() >= size) {
      refuse(place, key,
             "is " + value.dump() + ", but the file has " + std::to_string(size) + " " + std::string(property.target));
    }
  }

  const json& document_;
};

void check_transforms(const json& document) {
  const Place root{.outer = nullptr, .type = "document", .object = &document};
  std::ptrdiff_t index = 0;
  for (const json& node : document.value("nodes", json::array())) {
    const bool has_trs = node.contains("translation") || node.contains("rotation") || node.contains("scale");
    if (has_trs && node.contains("matrix")) {
      const Place place{.outer = &root, .type = "node", .object = &node, .index = index};
      refuse(place, "matrix", "stands beside a translation, rotation or scale");
    }
    ++index;
  }
}

void check_version(const json& document) {
  const std::string version = document["asset"]["version"].get<std::string>();
  if (!version.starts_with("2.")) throw Refusal("it is glTF " + version + ", not 2.0; export it as glTF 2.0");
}

void check_extensions(const json& document) {
  const auto extensions = document.find("extensionsRequired");
  if (extensions == document.end()) return;
  for (const json& extension : *extensions) {
    const auto name = extension.get<std::string>();
    if (std::ranges::find(known_extensions, name) == known_extensions.end()) {
      throw Refusal("it requires the extension " + name + ", which is not supported; export without it");
    }
  }
}

}  // namespace

void check_json(const json& document) {
  Checker(document).check_object({.outer = nullptr, .type = "document", .object = &document});
  check_transforms(document);
  check_version(document);
  check_extensions(document);
}

}  // namespace throng::import
