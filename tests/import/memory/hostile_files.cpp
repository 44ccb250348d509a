#include "tests/import/memory/hostile_files.h"

#include <cstddef>

#include "tests/import/memory/packed_zeros.h"

namespace throng::import::testing {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr int floats = 5126;
constexpr int bytes_type = 5121;

std::size_t add(json& document, const char* array, json object) {
  document[array].push_back(std::move(object));
  return document[array].size() - 1;
}

/// Writes a file beside the model, and returns the view that shows all of it.
std::size_t add_file(json& document, const TemporaryFolder& folder, const char* name, const std::vector<char>& bytes) {
  folder.write(name, bytes);
  const std::size_t buffer = add(document, "buffers", {{"byteLength", bytes.size()}, {"uri", name}});
  return add(document, "bufferViews", {{"buffer", buffer}, {"byteLength", bytes.size()}});
}

json numbers(std::size_t view, std::size_t count, const char* type, int component = floats) {
  return {{"bufferView", view}, {"count", count}, {"type", type}, {"componentType", component}};
}

fs::path write_model(const TemporaryFolder& folder, const json& document) {
  return folder.write("model.gltf", document.dump());
}

/// Gives the model a primitive for each of `count` images, which shows it.
json with_images(std::size_t count, const char* uri) {
  json document = editable_document();
  const std::size_t coords = add(document, "accessors", {{"count", 44}, {"type", "VEC2"}, {"componentType", floats}});
  json primitive = document["meshes"][0]["primitives"][0];
  primitive["attributes"]["TEXCOORD_0"] = coords;
  document["meshes"][0]["primitives"] = json::array();
  for (std::size_t i = 0; i < count; ++i) {
    add(document, "images", {{"uri", uri}, {"name", "skin"}});
    add(document, "textures", {{"source", i}});
    primitive["material"] =
        add(document, "materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", i}}}}}});
    document["meshes"][0]["primitives"].push_back(primitive);
  }
  return document;
}

fs::path shared_image(const TemporaryFolder& folder) {
  folder.write("skin.png", png_of_zeros(2048, 2048, false));
  return write_model(folder, with_images(40, "skin.png"));
}

fs::path inflating_png(const TemporaryFolder& folder) {
  return write_with_image(folder, "skin.png", png_of_zeros(4, 4, true, std::size_t{400} << 20U));
}

/// Each of many skeletons shows the image.
fs::path image_of_many_skeletons(const TemporaryFolder& folder) {
  constexpr std::size_t skeletons = 30;
  folder.write("skin.png", png_of_zeros(2048, 2048, false));
  json document = with_images(1, "skin.png");
  for (std::size_t i = 0; i < skeletons; ++i) {
    const std::size_t joint = add(document, "nodes", {{"name", "joint"}});
    const std::size_t skin = add(document, "skins", {{"joints", {joint}}});
    json mesh = document["meshes"][0];
    mesh["primitives"][0]["attributes"]["JOINTS_0"] =
        add(document, "accessors", {{"count", 44}, {"type", "VEC4"}, {"componentType", bytes_type}});
    const std::size_t body =
        add(document, "nodes", {{"mesh", add(document, "meshes", std::move(mesh))}, {"skin", skin}});
    document["scenes"][0]["nodes"].push_back(joint);
    document["scenes"][0]["nodes"].push_back(body);
  }
  return write_model(folder, document);
}

fs::path repeated_buffer(const TemporaryFolder& folder) {
  json document = editable_document();
  constexpr std::size_t size = std::size_t{2} << 20U;
  folder.write("data.bin", std::vector<char>(size));
  for (int i = 0; i < 300; ++i) add(document, "buffers", {{"byteLength", size}, {"uri", "data.bin"}});
  return write_model(folder, document);
}

/// Skins that a palette can hold, each with all joints of the others.
fs::path many_skins(const TemporaryFolder& folder) {
  json document = editable_document();
  const std::size_t first = document["nodes"].size();
  json joints = json::array();
  for (std::size_t i = 0; i < 1000; ++i) {
    add(document, "nodes", json::object());
    joints.push_back(first + i);
  }
  for (int i = 0; i < 1000; ++i) add(document, "skins", {{"joints", joints}});
  return write_model(folder, document);
}

/// Gives the model `count` primitives with vertices of their own.
template <typename PositionOf>
void add_primitives(json& document, std::size_t count, std::size_t vertices, PositionOf position_of) {
  const json plain = {{"count", vertices}, {"type", "VEC4"}};
  json joints = plain, weights = plain;
  joints["componentType"] = bytes_type;
  weights["componentType"] = floats;
  json attributes = {{"JOINTS_0", add(document, "accessors", joints)},
                     {"WEIGHTS_0", add(document, "accessors", weights)}};
  for (std::size_t i = 0; i < count; ++i) {
    attributes["POSITION"] = add(document, "accessors", position_of(i));
    document["meshes"][0]["primitives"].push_back({{"attributes", attributes}});
  }
}

fs::path sparse_of_huge_counts(const TemporaryFolder& folder) {
  json document = editable_document();
  const std::size_t view = add_file(document, folder, "data.bin", std::vector<char>(64));
  constexpr std::size_t vertices = 1'000'000;
  add_primitives(document, 8, vertices, [&](std::size_t) {
    json positions = {{"count", vertices}, {"type", "VEC3"}, {"componentType", floats}};
    positions["sparse"] = {{"count", 1},
                           {"indices", {{"bufferView", view}, {"componentType", 5125}}},
                           {"values", {{"bufferView", view}, {"byteOffset", 16}}}};
    return positions;
  });
  return write_model(folder, document);
}

fs::path overlapping_accessors(const TemporaryFolder& folder) {
  json document = editable_document();
  constexpr std::size_t vertices = 100'000;
  const std::size_t view = add_file(document, folder, "data.bin", std::vector<char>(vertices * 12 + 4096));
  add_primitives(document, 60, vertices, [&](std::size_t i) {
    json positions = numbers(view, vertices, "VEC3");
    positions["byteOffset"] = i * 4;
    return positions;
  });
  return write_model(folder, document);
}

fs::path repeated_meshopt(const TemporaryFolder& folder) {
  constexpr std::size_t count = 100'000;
  json document = editable_document();
  const std::vector<char> bytes = meshopt_of_zeros(count);
  folder.write("data.bin", bytes);
  const std::size_t buffer = add(document, "buffers", {{"byteLength", bytes.size()}, {"uri", "data.bin"}});
  const std::size_t fallback = add(document, "buffers", {{"byteLength", count * 64}});
  for (int i = 0; i < 60; ++i) {
    const json packed = {
        {"buffer", buffer}, {"byteLength", bytes.size()}, {"byteStride", 64}, {"count", count}, {"mode", "ATTRIBUTES"}};
    add(document, "bufferViews",
        {{"buffer", fallback}, {"byteLength", count * 64}, {"extensions", {{"EXT_meshopt_compression", packed}}}});
  }
  document["extensionsRequired"] = {"EXT_meshopt_compression"};
  return write_model(folder, document);
}

/// Gives the model `count` primitives of the same mesh.
fs::path with_draco(const TemporaryFolder& folder, int count, const std::vector<char>& mesh) {
  json document = editable_document();
  const std::size_t view = add_file(document, folder, "data.bin", mesh);
  const auto accessor = [&](const char* type, int component) {
    return add(document, "accessors", {{"count", 1}, {"type", type}, {"componentType", component}});
  };
  for (int i = 0; i < count; ++i) {
    json primitive = {{"attributes", {{"POSITION", accessor("VEC3", floats)}}}, {"indices", accessor("SCALAR", 5125)}};
    primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", view}, {"attributes", {{"POSITION", 0}}}};
    document["meshes"][0]["primitives"].push_back(primitive);
  }
  document["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  return write_model(folder, document);
}

fs::path repeated_draco(const TemporaryFolder& folder) { return with_draco(folder, 20, draco_square(500)); }

fs::path wide_draco(const TemporaryFolder& folder) { return with_draco(folder, 1, draco_square(450, 100)); }

/// Every channel of many animations plays the same keys.
fs::path shared_keys(const TemporaryFolder& folder) {
  constexpr std::size_t keys = 20'000;
  json document = editable_document();
  std::vector<char> times;
  for (std::size_t key = 0; key < keys; ++key) {
    const auto time = static_cast<float>(key);
    const auto* bytes = reinterpret_cast<const char*>(&time);
    times.insert(times.end(), bytes, bytes + sizeof time);
  }
  const std::size_t input =
      add(document, "accessors", numbers(add_file(document, folder, "times.bin", times), keys, "SCALAR"));
  const std::size_t view = add_file(document, folder, "values.bin", std::vector<char>(keys * 16, 1));
  const std::size_t turns = add(document, "accessors", numbers(view, keys, "VEC4"));
  const std::size_t moves = add(document, "accessors", numbers(view, keys, "VEC3"));
  json animation = {{"samplers", {{{"input", input}, {"output", turns}}, {{"input", input}, {"output", moves}}}}};
  for (int node = 1; node <= 5; ++node) {
    animation["channels"].push_back({{"sampler", 0}, {"target", {{"node", node}, {"path", "rotation"}}}});
    animation["channels"].push_back({{"sampler", 1}, {"target", {{"node", node}, {"path", "translation"}}}});
  }
  for (int i = 0; i < 150; ++i) add(document, "animations", animation);
  return write_model(folder, document);
}

/// One accessor displaces the vertices for every one of many targets, all of which an animation moves.
fs::path shared_morph_target(const TemporaryFolder& folder) {
  constexpr std::size_t vertices = 50'000, targets = 400;
  json document = editable_document();
  const std::size_t view = add_file(document, folder, "data.bin", std::vector<char>(vertices * 12, 0x3F));
  const std::size_t offsets = add(document, "accessors", numbers(view, vertices, "VEC3"));
  add_primitives(document, 1, vertices, [&](std::size_t) { return numbers(view, vertices, "VEC3"); });
  json& primitives = document["meshes"][0]["primitives"];
  primitives.erase(0);
  for (std::size_t i = 0; i < targets; ++i) primitives[0]["targets"].push_back({{"POSITION", offsets}});
  const std::size_t weights = add(document, "accessors", numbers(view, targets * 4, "SCALAR"));
  document["animations"][0]["samplers"].push_back({{"input", 6}, {"output", weights}});
  document["animations"][0]["channels"].push_back({{"sampler", 5}, {"target", {{"node", 6}, {"path", "weights"}}}});
  return write_model(folder, document);
}

/// Every sentence about a primitive has the name of its mesh.
fs::path long_name(const TemporaryFolder& folder) {
  json document = editable_document();
  document["meshes"][0]["name"] = std::string(std::size_t{1} << 20U, 'n');
  json primitive = document["meshes"][0]["primitives"][0];
  primitive["attributes"].erase("JOINTS_0");
  for (int i = 0; i < 500; ++i) document["meshes"][0]["primitives"].push_back(primitive);
  return write_model(folder, document);
}

/// Every skin draws the mesh, of which no primitive can be drawn.
/// Which sentence or primitive is one too many depends on the size of tinygltf's types.
fs::path many_sentences(const TemporaryFolder& folder) {
  json document = editable_document();
  document["meshes"][0]["primitives"].insert(document["meshes"][0]["primitives"].end(), 700,
                                             {{"attributes", json::object()}});
  for (int i = 0; i < 700; ++i) {
    const std::size_t skin = add(document, "skins", document["skins"][0]);
    document["scenes"][0]["nodes"].push_back(add(document, "nodes", {{"mesh", 0}, {"skin", skin}}));
  }
  return write_model(folder, document);
}

/// Nodes that an animation moves are bones of every skeleton below them.
fs::path bones_of_many_skeletons(const TemporaryFolder& folder) {
  constexpr std::size_t moved = 500, skeletons = 500;
  json document = editable_document();
  json& nodes = document["nodes"];
  json& animation = document["animations"][0];
  document["scenes"][0]["nodes"].push_back(nodes.size());
  for (std::size_t i = 0; i < moved; ++i) {
    animation["channels"].push_back({{"sampler", 0}, {"target", {{"node", nodes.size()}, {"path", "rotation"}}}});
    nodes.push_back({{"children", {nodes.size() + 1}}});
  }
  json joints = json::array();
  for (std::size_t i = 0; i < skeletons; ++i) joints.push_back(nodes.size() + 1 + i);
  nodes.push_back({{"children", joints}});
  nodes.insert(nodes.end(), skeletons, json::object());
  for (const json& joint : joints) add(document, "skins", {{"joints", {joint}}});
  return write_model(folder, document);
}

/// A few characters of JSON are a node of hundreds of bytes.
fs::path many_empty_nodes(const TemporaryFolder& folder) {
  json document = editable_document();
  document["nodes"].insert(document["nodes"].end(), 300'000, json::object());
  return write_model(folder, document);
}

}  // namespace

fs::path write_with_image(const TemporaryFolder& folder, const char* name, const std::vector<char>& bytes) {
  folder.write(name, bytes);
  return write_model(folder, with_images(1, name));
}

fs::path write_with_images(const TemporaryFolder& folder, std::size_t count, const std::vector<char>& png) {
  json document = with_images(count, "");
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = "skin" + std::to_string(i) + ".png";
    folder.write(name, png);
    document["images"][i]["uri"] = name;
  }
  return write_model(folder, document);
}

std::filesystem::path write_skins_of_many_joints(const TemporaryFolder& folder) {
  json document = editable_document();
  const std::size_t first = document["nodes"].size();
  json joints = json::array();
  for (std::size_t i = 0; i < 70'000; ++i) {
    add(document, "nodes", json::object());
    joints.push_back(first + i);
  }
  for (int i = 0; i < 20; ++i) add(document, "skins", {{"joints", joints}});
  return write_model(folder, document);
}

const std::vector<HostileFile>& hostile_files() {
  static const std::vector<HostileFile> files{{"ImageThatManyShow", shared_image, ""},
                                              {"PngThatInflates", inflating_png, ""},
                                              {"ImageOfManySkeletons", image_of_many_skeletons, ""},
                                              {"BufferThatManyName", repeated_buffer, ""},
                                              {"ManySkins", many_skins, "skin"},
                                              {"SparseOfHugeCounts", sparse_of_huge_counts, "mesh 0, primitive 1"},
                                              {"OverlappingAccessors", overlapping_accessors, "mesh 0, primitive"},
                                              {"MeshoptThatManyViewsName", repeated_meshopt, "buffer view"},
                                              {"DracoThatManyMeshesName", repeated_draco, "mesh 0, primitive"},
                                              {"DracoOfManyChannels", wide_draco, "mesh 0, primitive 1"},
                                              {"KeysThatManyChannelsPlay", shared_keys, "animation"},
                                              {"MorphTargetThatManyNames", shared_morph_target, "mesh 0, primitive 0"},
                                              {"NameInManySentences", long_name, ""},
                                              {"ManySentences", many_sentences, " needs "},
                                              {"BonesOfManySkeletons", bones_of_many_skeletons, "skeleton"},
                                              {"ManyEmptyNodes", many_empty_nodes, "its JSON"}};
  return files;
}

}  // namespace throng::import::testing
