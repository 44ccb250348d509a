#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <unordered_set>

#include <nlohmann/json.hpp>

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/import/bytes/refusal.h"
#include "engine/anim/import/json_document.h"
#include "engine/anim/import/json_properties.h"

namespace throng::import {

namespace {

using nlohmann::json;

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

[[noreturn]] void refuse_property(const Place& place, std::string_view key, const std::string& what) {
  refuse(describe(place), "\"" + std::string(key) + "\" " + what);
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
    for (const Property& property : read_properties()) {
      if (property.owner != place.type) continue;
      if (property.key == "*") {
        for (const auto& [key, value] : place.object->items()) check_value(place, key, property, value);
        continue;
      }
      const auto found = place.object->find(property.key);
      if (found != place.object->end()) {
        check_value(place, property.key, property, *found);
      } else if (property.required) {
        refuse_property(place, property.key, "is missing");
      }
    }
  }

 private:
  void check_value(const Place& place, std::string_view key, const Property& property, const json& value) const {
    switch (property.kind) {
      case Kind::flag:
        if (!value.is_boolean()) refuse_property(place, key, "is neither true nor false");
        break;
      case Kind::integer:
        if (!is_count(value)) refuse_property(place, key, "is not a whole number of at least 0");
        break;
      case Kind::number:
        check_number(place, key, value);
        break;
      case Kind::text:
        if (!value.is_string()) refuse_property(place, key, "is not a text");
        break;
      case Kind::choice:
        if (!value.is_string() || !lists(property.target, value.get_ref<const std::string&>())) {
          refuse_property(place, key, "is none of " + std::string(property.target));
        }
        break;
      case Kind::index:
        check_index(place, key, property, value);
        break;
      case Kind::object:
        if (!value.is_object()) refuse_property(place, key, "is not an object");
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
    if (!value.is_array()) refuse_property(place, key, "is not an array");
    const auto count = static_cast<std::size_t>(property.count);
    if (property.kind == Kind::numbers && count != 0 && value.size() != count) {
      refuse_property(place, key, "has " + std::to_string(value.size()) + " numbers, not " + std::to_string(count));
    }
    if (value.size() < count) refuse_property(place, key, "is empty");
    std::unordered_set<std::int64_t> seen;
    std::ptrdiff_t index = 0;
    for (const json& element : value) {
      if (property.kind == Kind::objects) {
        if (!element.is_object()) refuse_property(place, key, "holds what is not an object");
        check_object({.outer = &place, .type = property.target, .object = &element, .index = index});
      } else {
        Property single = property;
        single.kind = element_kind(property.kind);
        check_value(place, key, single, element);
        if (property.kind == Kind::indices && !seen.insert(element.get<std::int64_t>()).second) {
          refuse_property(place, key, "names " + element.dump() + " twice");
        }
      }
      ++index;
    }
  }

  /// Bounds are in double, and some exporters write the largest there is.
  static void check_number(const Place& place, std::string_view key, const json& value) {
    if (!value.is_number() || !std::isfinite(value.get<double>())) refuse_property(place, key, "is not a number");
    const bool is_bound = place.type == "accessor";
    if (!is_bound && std::abs(value.get<double>()) > static_cast<double>(std::numeric_limits<float>::max())) {
      refuse_property(place, key, "is " + value.dump() + ", more than a float holds");
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
    if (!is_count(value)) refuse_property(place, key, "is " + value.dump() + ", which is no index");
    const auto array = document_.find(property.target);
    const std::size_t size = array == document_.end() ? 0 : array->size();
    if (value.get<std::uint64_t>() >= size) {
      refuse_property(
          place, key,
          "is " + value.dump() + ", but the file has " + std::to_string(size) + " " + std::string(property.target));
    }
  }

  const json& document_;
};

void check_transforms(const json& document) {
  const Place root{.outer = nullptr, .type = "document", .object = &document};
  std::ptrdiff_t index = 0;
  for (const json& node : array_of(document, "nodes")) {
    const bool has_trs = node.contains("translation") || node.contains("rotation") || node.contains("scale");
    if (has_trs && node.contains("matrix")) {
      const Place place{.outer = &root, .type = "node", .object = &node, .index = index};
      refuse_property(place, "matrix", "stands beside a translation, rotation or scale");
    }
    ++index;
  }
}

/// Each joint would be a bone. Their indices alone may take megabytes.
void check_joints(const json& document) {
  std::size_t index = 0;
  for (const json& skin : array_of(document, "skins")) {
    const std::size_t joints = array_of(skin, "joints").size();
    if (joints > static_cast<std::size_t>(anim::max_bones)) {
      throw Refusal(json_label("skin", index, skin) + ": has " + std::to_string(joints) + " joints, and " +
                    std::to_string(anim::max_bones) + " are the most; split the model");
    }
    ++index;
  }
}

/// A file of a later 2.x says by minVersion whether 2.0 is enough to read it (glTF 2.0, 5.9).
void check_version(const json& document) {
  const std::string version = document["asset"]["version"].get<std::string>();
  if (!version.starts_with("2.")) throw Refusal("it is glTF " + version + ", not 2.0; export it as glTF 2.0");
  const std::string least = document["asset"].value("minVersion", std::string("2.0"));
  if (least != "2.0") throw Refusal("it needs glTF " + least + ", and 2.0 is supported; export it as glTF 2.0");
}

}  // namespace

void check_json(const json& document) {
  Checker(document).check_object({.outer = nullptr, .type = "document", .object = &document});
  check_transforms(document);
  check_joints(document);
  check_version(document);
}

}  // namespace throng::import
