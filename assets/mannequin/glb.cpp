#include "assets/mannequin/glb.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

#include "assets/making/glb_container.h"

namespace throng::mannequin {
namespace {

using making::BufferWriter;
using making::ComponentType;
using making::Json;
using making::Target;

using Float3 = std::array<float, 3>;
using Float4 = std::array<float, 4>;

float rounded(double value, double step) { return static_cast<float>(std::round(value / step) * step + 0.0); }
Float3 rounded(glm::dvec3 v, double step) { return {rounded(v.x, step), rounded(v.y, step), rounded(v.z, step)}; }

template <typename Element, typename Member>
std::vector<Element> column(const Mesh& mesh, Member member) {
  std::vector<Element> values;
  for (const MeshVertex& vertex : mesh.vertices) values.push_back(member(vertex));
  return values;
}

Json add_mesh(BufferWriter& buffer, const Mesh& mesh, const std::string& name) {
  const auto positions = column<Float3>(mesh, [](const MeshVertex& v) {
    return Float3{v.position.x, v.position.y, v.position.z};
  });
  const auto normals = column<Float3>(mesh, [](const MeshVertex& v) {
    return Float3{v.normal.x, v.normal.y, v.normal.z};
  });
  using Byte4 = std::array<std::uint8_t, 4>;
  const auto joints = column<Byte4>(mesh, [](const MeshVertex& v) { return v.joints; });
  const auto weights = column<Float4>(mesh, [](const MeshVertex& v) { return v.weights; });
  const auto colours = column<Byte4>(mesh, [](const MeshVertex& v) { return v.colour; });
  const auto regions = column<float>(mesh, [](const MeshVertex& v) { return v.region; });

  Json attributes;
  attributes["POSITION"] = buffer.add<Float3>(positions, "VEC3", ComponentType::float32, Target::vertex_data);
  buffer.set_bounds<3>(attributes["POSITION"], positions);
  attributes["NORMAL"] = buffer.add<Float3>(normals, "VEC3", ComponentType::float32, Target::vertex_data);
  attributes["JOINTS_0"] = buffer.add<Byte4>(joints, "VEC4", ComponentType::unsigned_byte, Target::vertex_data);
  attributes["WEIGHTS_0"] = buffer.add<Float4>(weights, "VEC4", ComponentType::float32, Target::vertex_data);
  attributes["COLOR_0"] = buffer.add<Byte4>(colours, "VEC4", ComponentType::unsigned_byte, Target::vertex_data, true);
  attributes["_REGION"] = buffer.add<float>(regions, "SCALAR", ComponentType::float32, Target::vertex_data);

  using Float2 = std::array<float, 2>;
  const auto shapes = column<Float3>(mesh, [](const MeshVertex& v) { return Float3{v.shape.x, v.shape.y, v.shape.z}; });
  const auto hair = column<Float2>(mesh, [](const MeshVertex& v) { return Float2{v.hair.x, v.hair.y}; });
  attributes["_SHAPE"] = buffer.add<Float3>(shapes, "VEC3", ComponentType::float32, Target::vertex_data);
  attributes["_HAIR"] = buffer.add<Float2>(hair, "VEC2", ComponentType::float32, Target::vertex_data);

  std::vector<std::uint16_t> indices;
  for (const auto& triangle : mesh.triangles) indices.insert(indices.end(), triangle.begin(), triangle.end());
  const std::size_t index_accessor =
      buffer.add<std::uint16_t>(indices, "SCALAR", ComponentType::unsigned_short, Target::index_data);
  const Json primitive{{"attributes", attributes}, {"indices", index_accessor}, {"material", 0}};
  return {{"name", name}, {"primitives", Json::array({primitive})}};
}

}  // namespace

Json joint_nodes() {
  const auto& joints = skeleton();
  Json nodes = Json::array();
  for (std::size_t j = 0; j < joint_count; ++j) {
    Json node{{"name", joints[j].name}};
    if (j > 0) node["translation"] = rounded(joints[j].position - joints[joints[j].parent].position, offset_step);
    Json children = Json::array();
    for (std::size_t c = j + 1; c < joint_count; ++c) {
      if (joints[c].parent == j) children.push_back(c);
    }
    if (!children.empty()) node["children"] = children;
    nodes.push_back(node);
  }
  return nodes;
}

std::vector<std::array<float, 16>> inverse_binds() {
  const auto& joints = skeleton();
  std::array<glm::dvec3, joint_count> places{};
  std::vector<std::array<float, 16>> matrices;
  for (std::size_t j = 0; j < joint_count; ++j) {
    const Float3 step =
        rounded(joints[j].position - (j > 0 ? joints[joints[j].parent].position : glm::dvec3(0)), offset_step);
    places[j] = (j > 0 ? places[joints[j].parent] : glm::dvec3(0)) + glm::dvec3(step[0], step[1], step[2]);
    const Float3 inverse = rounded(-places[j], offset_step);
    matrices.push_back({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, inverse[0], inverse[1], inverse[2], 1});
  }
  return matrices;
}

namespace {

/// A joint's rotations over a clip, neighbours in the same hemisphere.
std::vector<Float4> rotation_keys(const Clip& clip, std::size_t joint) {
  std::vector<Float4> keys;
  glm::dquat last(1, 0, 0, 0);
  for (const Pose& pose : clip.keys) {
    glm::dquat q = glm::normalize(pose.rotations[joint]);
    if (glm::dot(q, last) < 0) q = -q;
    keys.push_back({rounded(q.x, rotation_step), rounded(q.y, rotation_step), rounded(q.z, rotation_step),
                    rounded(q.w, rotation_step)});
    last = q;
  }
  return keys;
}

/// Writes the tracks of one clip; a track that stays at rest is left out.
class AnimationWriter {
 public:
  AnimationWriter(BufferWriter& buffer, const Clip& clip) : buffer_(buffer), clip_(clip) {
    std::vector<std::array<float, 1>> times;
    for (std::size_t key = 0; key < clip.keys.size(); ++key) {
      times.push_back({static_cast<float>(static_cast<double>(key) / key_rate)});
    }
    times_ = buffer.add<std::array<float, 1>>(times, "SCALAR", ComponentType::float32, Target::none);
    buffer.set_bounds<1>(times_, times);
  }

  Json write() {
    add_translations(0, [](const Pose& pose) { return pose.root; });
    add_translations(1, [](const Pose& pose) { return skeleton()[1].position + pose.hips; });
    for (std::size_t joint = 0; joint < joint_count; ++joint) {
      const std::vector<Float4> keys = rotation_keys(clip_, joint);
      add_track<4>(joint, "rotation", "VEC4", keys, {0, 0, 0, 1});
    }
    Json animation{{"name", clip_.name}, {"channels", channels_}, {"samplers", samplers_}};
    if (!clip_.marks.empty()) animation["extras"] = {{"throng_data_keys", data_keys()}};
    return animation;
  }

 private:
  /// engine/anim/import/README.md, "Data keys".
  [[nodiscard]] Json data_keys() const {
    Json keys = Json::array();
    const double duration = static_cast<double>(clip_.keys.size() - 1) / key_rate;
    for (const Mark& mark : clip_.marks) {
      keys.push_back({{"time", std::round(mark.phase * duration / mark_step) * mark_step}, {"name", mark.name}});
    }
    return keys;
  }

  template <typename Member>
  void add_translations(std::size_t joint, Member member) {
    std::vector<Float3> keys;
    for (const Pose& pose : clip_.keys) keys.push_back(rounded(member(pose), offset_step));
    add_track<3>(joint, "translation", "VEC3", keys, rounded(skeleton()[joint].position, offset_step));
  }

  template <std::size_t N>
  void add_track(std::size_t joint, const char* path, const char* type, const std::vector<std::array<float, N>>& keys,
                 const std::array<float, N>& rest) {
    if (std::all_of(keys.begin(), keys.end(), [&](const auto& key) { return key == rest; })) return;
    const std::size_t output = buffer_.add<std::array<float, N>>(keys, type, ComponentType::float32, Target::none);
    channels_.push_back({{"sampler", samplers_.size()}, {"target", {{"node", joint}, {"path", path}}}});
    samplers_.push_back({{"input", times_}, {"interpolation", "LINEAR"}, {"output", output}});
  }

  BufferWriter& buffer_;
  const Clip& clip_;
  std::size_t times_ = 0;
  Json channels_ = Json::array();
  Json samplers_ = Json::array();
};

Json document_head() {
  return {{"asset", {{"version", "2.0"}, {"generator", "throng_mannequin"}, {"copyright", "MIT licence"}}},
          {"scene", 0},
          {"scenes", Json::array({{{"name", "scene"}, {"nodes", {0, joint_count}}}})}};
}

Json document(BufferWriter& buffer, const Mesh& body, std::span<const Clip> clips, const std::string& name) {
  Json file = document_head();
  file["nodes"] = joint_nodes();
  file["nodes"].push_back({{"name", name}, {"mesh", 0}, {"skin", 0}});
  file["meshes"] = Json::array({add_mesh(buffer, body, name)});
  file["materials"] =
      Json::array({{{"name", name},
                    {"pbrMetallicRoughness",
                     {{"baseColorFactor", {1, 1, 1, 1}}, {"metallicFactor", 0}, {"roughnessFactor", 0.85}}}}});
  const std::vector<std::array<float, 16>> binds = inverse_binds();
  Json joints = Json::array();
  for (std::size_t j = 0; j < joint_count; ++j) joints.push_back(j);
  file["skins"] = Json::array(
      {{{"name", name},
        {"inverseBindMatrices", buffer.add<std::array<float, 16>>(binds, "MAT4", ComponentType::float32, Target::none)},
        {"skeleton", 0},
        {"joints", joints}}});
  file["animations"] = Json::array();
  for (const Clip& clip : clips) file["animations"].push_back(AnimationWriter(buffer, clip).write());
  buffer.finish(file);
  return file;
}

}  // namespace

std::vector<std::byte> write_glb(const Mesh& body, std::span<const Clip> clips, const std::string& name) {
  BufferWriter buffer;
  const Json file = document(buffer, body, clips, name);
  return making::glb_container(file, buffer.bytes());
}

}  // namespace throng::mannequin
