#include "engine/anim/import/json_properties.h"

#include <array>

#include "engine/anim/import/json_document.h"

namespace throng::import {

namespace {

constexpr bool required = true;

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

    {"node", part_property, Kind::object, "part"},
    {"part", "slot", Kind::text, {}, 0, required},
    {"part", "body", Kind::text},
    {"part", "covers", Kind::texts},
    {"part", "keeps_out", Kind::texts},
    {"part", "tags", Kind::texts},
    {"part", "error", Kind::number},

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
    {"animation", curves_property, Kind::object, "curves"},
    {"data key", "time", Kind::number, {}, 0, required},
    {"data key", "name", Kind::text, {}, 0, required},
    {"curves", "*", Kind::object, "curve"},
    {"curve", "times", Kind::numbers, {}, 0, required},
    {"curve", "values", Kind::numbers, {}, 0, required},
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

}  // namespace

std::span<const Property> read_properties() { return properties; }

}  // namespace throng::import
