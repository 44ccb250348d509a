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

#include "engine/anim/import/json_document.h"
#include "engine/anim/import/refusal.h"

namespace throng::import {

namespace {

using nlohmann::json;

/// The kinds of property that a glTF object has.
enum class Kind : unsigned char {
  flag,
  integer,  ///< >= 0
  number,   ///< finite, as a float too
  numbers,  ///< array of `count` finite numbers; of any length where count is 0
  text,
  choice,  ///< one of the texts that `target` lists, divided by "|"
  texts,
  index,    ///< into the document's top-level array `target`
  indices,  ///< array of indices, at least `count`, no two equal
  object,   ///< of the type `target`
  objects,  ///< array of objects, at least `count`
};

/// One property of one type of object (glTF 2.0, chapter 5). The key "*" stands for every key of the object.
struct Property {
  std::string_view owner;
  std::string_view key;
  Kind kind = Kind::text;
  std::string_view target = {};
  int count = 0;
  bool required = false;
};

constexpr bool required = true;

/// The properties that import reads, grouped by owner. All others are ignored.
constexpr auto properties = std::to_array<Property>({
    {"document", "asset", Kind::object, "asset", 0, required},
    {"document", "scene", Kind::index, "scenes"},
    {"document", "scenes", Kind::objects, "scene"},
    {"document", "nodes", Kind::objects, "node"},
    {"document", "meshes", Kind::objects, "mesh"},
    {"document", "accessors", Kind::objects, "accessor"},
    {"document", "bufferViews", Kind::objects, "buffer view"},
    {"document", "buffers", Kind::objects, "buffer"},
    {"document", "skins", Kind::objects, "skin"},
    {"document", "animations", Kind::objects, "animation"},
    {"document", "materials", Kind::objects, "material"},
    {"document", "textures", Kind::objects, "texture"},
    {"document", "images", Kind::objects, "image"},
    {"document", "samplers", Kind::objects, "texture sampler"},
    {"document", "extensionsRequired", Kind::texts},

    {"asset", "version", Kind::text, {}, 0, required},
    {"asset", "minVersion", Kind::text},

    {"scene", "nodes", Kind::indices, "nodes"},

    {"node", "name", Kind::text},
    {"node", "mesh", Kind::index, "meshes"},
    {"node", "skin", Kind::index, "skins"},
    {"node", "children", Kind::indices, "nodes"},
    {"node", "matrix", Kind::numbers, {}, 16},
    {"node", "translation", Kind::numbers, {}, 3},
    {"node", "rotation", Kind::numbers, {}, 4},
    {"node", "scale", Kind::numbers, {}, 3},

    {"node", "weights", Kind::numbers},
    {"node", "extensions", Kind::object, "node extensions"},
    {"node extensions", "KHR_node_visibility", Kind::object, "node visibility"},
    {"node visibility", "visible", Kind::flag},

    {"node", mesh_lods_property, Kind::objects, "mesh LOD"},
    {"mesh LOD", "node", Kind::index, "nodes", 0, required},
    {"mesh LOD", "error", Kind::number, {}, 0, required},

    {"mesh", "name", Kind::text},
    {"mesh", "weights", Kind::numbers},
    {"mesh", "primitives", Kind::objects, "primitive", 1, required},

    {"primitive", "attributes", Kind::object, "attributes", 0, required},
    {"primitive", "indices", Kind::index, "accessors"},
    {"primitive", "material", Kind::index, "materials"},
    {"primitive", "mode", Kind::integer},
    {"primitive", "targets", Kind::objects, "attributes"},

    {"attributes", "*", Kind::index, "accessors"},

    {"primitive", "extensions", Kind::object, "primitive extensions"},
    {"primitive extensions", "KHR_draco_mesh_compression", Kind::object, "draco mesh"},
    {"draco mesh", "bufferView", Kind::index, "bufferViews", 0, required},
    {"draco mesh", "attributes", Kind::object, "draco attributes", 0, required},
    {"draco attributes", "*", Kind::integer},

    {"accessor", "bufferView", Kind::index, "bufferViews"},
    {"accessor", "byteOffset", Kind::integer},
    {"accessor", "componentType", Kind::integer, {}, 0, required},
    {"accessor", "normalized", Kind::flag},
    {"accessor", "count", Kind::integer, {}, 0, required},
    {"accessor", "type", Kind::choice, "SCALAR|VEC2|VEC3|VEC4|MAT2|MAT3|MAT4", 0, required},
    {"accessor", "min", Kind::numbers},
    {"accessor", "max", Kind::numbers},
    {"accessor", "sparse", Kind::object, "sparse"},

    {"sparse", "count", Kind::integer, {}, 0, required},
    {"sparse", "indices", Kind::object, "sparse indices", 0, required},
    {"sparse", "values", Kind::object, "sparse values", 0, required},
    {"sparse indices", "bufferView", Kind::index, "bufferViews", 0, required},
    {"sparse indices", "byteOffset", Kind::integer},
    {"sparse indices", "componentType", Kind::integer, {}, 0, required},
    {"sparse values", "bufferView", Kind::index, "bufferViews", 0, required},
    {"sparse values", "byteOffset", Kind::integer},

    {"buffer view", "buffer", Kind::index, "buffers", 0, required},
    {"buffer view", "byteOffset", Kind::integer},
    {"buffer view", "byteLength", Kind::integer, {}, 0, required},
    {"buffer view", "byteStride", Kind::integer},
    {"buffer view", "extensions", Kind::object, "buffer view extensions"},

    {"buffer view extensions", "EXT_meshopt_compression", Kind::object, "meshopt compression"},
    {"buffer view extensions", "KHR_meshopt_compression", Kind::object, "meshopt compression"},
    {"meshopt compression", "buffer", Kind::index, "buffers", 0, required},
    {"meshopt compression", "byteOffset", Kind::integer},
    {"meshopt compression", "byteLength", Kind::integer, {}, 0, required},
    {"meshopt compression", "byteStride", Kind::integer, {}, 0, required},
    {"meshopt compression", "count", Kind::integer, {}, 0, required},
    {"meshopt compression", "mode", Kind::choice, "ATTRIBUTES|TRIANGLES|INDICES", 0, required},
    {"meshopt compression", "filter", Kind::choice, "NONE|OCTAHEDRAL|QUATERNION|EXPONENTIAL|COLOR"},

    {"buffer", "byteLength", Kind::integer, {}, 0, required},
    {"buffer", "uri", Kind::text},

    {"skin", "name", Kind::text},
    {"skin", "joints", Kind::indices, "nodes", 1, required},
    {"skin", "inverseBindMatrices", Kind::index, "accessors"},
    {"skin", "skeleton", Kind::index, "nodes"},

    {"animation", "name", Kind::text},
    {"animation", "channels", Kind::objects, "channel", 1, required},
    {"animation", "samplers", Kind::objects, "sampler", 1, required},
    {"animation", data_keys_property, Kind::objects, "data key"},
    {"data key", "time", Kind::number, {}, 0, required},
    {"data key", "name", Kind::text, {}, 0, required},
    {"channel", "sampler", Kind::integer, {}, 0, required},
    {"channel", "target", Kind::object, "target", 0, required},
    {"target", "node", Kind::index, "nodes"},
    {"target", "path", Kind::choice, "translation|rotation|scale|weights", 0, required},
    {"sampler", "input", Kind::index, "accessors", 0, required},
    {"sampler", "output", Kind::index, "accessors", 0, required},
    {"sampler", "interpolation", Kind::choice, "LINEAR|STEP|CUBICSPLINE"},

    {"material", "name", Kind::text},
    {"material", "pbrMetallicRoughness", Kind::object, "metallic roughness"},
    {"material", "doubleSided", Kind::flag},
    {"material", "alphaMode", Kind::choice, "OPAQUE|MASK|BLEND"},
    {"material", "alphaCutoff", Kind::number},
    {"material", "emissiveFactor", Kind::numbers, {}, 3},
    {"material", "emissiveTexture", Kind::object, "texture reference"},
    {"material", "normalTexture", Kind::object, "texture reference"},
    {"material", "occlusionTexture", Kind::object, "texture reference"},
    {"material", "extensions", Kind::object, "material extensions"},
    {"metallic roughness", "baseColorFactor", Kind::numbers, {}, 4},
    {"metallic roughness", "baseColorTexture", Kind::object, "texture reference"},
    {"metallic roughness", "metallicFactor", Kind::number},
    {"metallic roughness", "roughnessFactor", Kind::number},
    {"metallic roughness", "metallicRoughnessTexture", Kind::object, "texture reference"},

    {"material extensions", "KHR_materials_emissive_strength", Kind::object, "emissive strength"},
    {"material extensions", "KHR_materials_pbrSpecularGlossiness", Kind::object, "specular glossiness"},
    {"material extensions", "KHR_materials_unlit", Kind::object, "unlit"},
    {"emissive strength", "emissiveStrength", Kind::number},
    {"specular glossiness", "diffuseFactor", Kind::numbers, {}, 4},
    {"specular glossiness", "diffuseTexture", Kind::object, "texture reference"},
    {"specular glossiness", "specularFactor", Kind::numbers, {}, 3},
    {"specular glossiness", "glossinessFactor", Kind::number},
    {"specular glossiness", "specularGlossinessTexture", Kind::object, "texture reference"},

    {"texture reference", "index", Kind::index, "textures", 0, required},
    {"texture reference", "texCoord", Kind::integer},
    {"texture reference", "scale", Kind::number},
    {"texture reference", "strength", Kind::number},
    {"texture reference", "extensions", Kind::object, "texture reference extensions"},
    {"texture reference extensions", "KHR_texture_transform", Kind::object, "texture transform"},
    {"texture transform", "offset", Kind::numbers, {}, 2},
    {"texture transform", "scale", Kind::numbers, {}, 2},
    {"texture transform", "rotation", Kind::number},
    {"texture transform", "texCoord", Kind::integer},

    {"texture", "source", Kind::index, "images"},
    {"texture", "sampler", Kind::index, "samplers"},
    {"texture", "extensions", Kind::object, "texture extensions"},
    {"texture extensions", "EXT_texture_webp", Kind::object, "image reference"},
    {"texture extensions", "KHR_texture_basisu", Kind::object, "image reference"},
    {"image reference", "source", Kind::index, "images"},
    {"texture sampler", "name", Kind::text},
    {"texture sampler", "magFilter", Kind::integer},
    {"texture sampler", "minFilter", Kind::integer},
    {"texture sampler", "wrapS", Kind::integer},
    {"texture sampler", "wrapT", Kind::integer},

    {"image", "uri", Kind::text},
    {"image", "bufferView", Kind::index, "bufferViews"},
});

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
    for (const Property& property : properties) {
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
  for (const json& node : document.value("nodes", json::array())) {
    const bool has_trs = node.contains("translation") || node.contains("rotation") || node.contains("scale");
    if (has_trs && node.contains("matrix")) {
      const Place place{.outer = &root, .type = "node", .object = &node, .index = index};
      refuse_property(place, "matrix", "stands beside a translation, rotation or scale");
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
  check_version(document);
}

}  // namespace throng::import
