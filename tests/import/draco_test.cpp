#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/import/draco_meshes.h"
#include "tests/import/test_files.h"

// A feature file whose only mesh is packed here, by the encoder of the library that unpacks it.

namespace throng::import::testing::draco_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The mesh of the feature: its views, in the buffer.
struct Source {
  std::vector<char> buffer = editable_buffer();

  template <typename Value>
  Value at(std::size_t byte) const {
    Value value;
    std::memcpy(&value, buffer.data() + byte, sizeof value);
    return value;
  }
  std::array<float, 3> position(std::size_t vertex) const { return at<std::array<float, 3>>(vertex * 12); }
  std::array<std::uint8_t, 4> joints(std::size_t vertex) const {
    return at<std::array<std::uint8_t, 4>>(528 + vertex * 4);
  }
  std::array<float, 4> weights(std::size_t vertex) const { return at<std::array<float, 4>>(704 + vertex * 16); }
  std::size_t corner(std::size_t index) const { return at<std::uint16_t>(1408 + index * 2); }
};

constexpr std::size_t triangle_count = 80;

struct Packed {
  std::vector<char> bytes;
  std::size_t points = 0;
  json attributes;
};

/// Packs without quantising, so that positions come back to the bit.
Packed pack(draco::MeshEncoderMethod method) {
  const Source source;
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(triangle_count);
  const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int joints = builder.AddAttribute(draco::GeometryAttribute::GENERIC, 4, draco::DT_UINT8);
  const int weights = builder.AddAttribute(draco::GeometryAttribute::GENERIC, 4, draco::DT_FLOAT32);
  for (std::size_t face = 0; face < triangle_count; ++face) {
    const std::size_t a = source.corner(face * 3), b = source.corner(face * 3 + 1), c = source.corner(face * 3 + 2);
    const draco::FaceIndex index(static_cast<std::uint32_t>(face));
    const auto set = [&](int attribute, auto value_of) {
      const auto first = value_of(a), second = value_of(b), third = value_of(c);
      builder.SetAttributeValuesForFace(attribute, index, first.data(), second.data(), third.data());
    };
    set(position, [&](std::size_t vertex) { return source.position(vertex); });
    set(joints, [&](std::size_t vertex) { return source.joints(vertex); });
    set(weights, [&](std::size_t vertex) { return source.weights(vertex); });
  }
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  draco::EncoderBuffer encoded;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &encoded).ok());
  const auto id = [&](int attribute) { return mesh->attribute(attribute)->unique_id(); };
  return {.bytes = {encoded.data(), encoded.data() + encoded.size()},
          .points = mesh->num_points(),
          .attributes = {{"POSITION", id(position)}, {"JOINTS_0", id(joints)}, {"WEIGHTS_0", id(weights)}}};
}

class PackedMesh : public ::testing::TestWithParam<draco::MeshEncoderMethod> {
 protected:
  /// Writes the feature with its mesh packed. Its accessors have no views, as exporters leave them.
  std::filesystem::path write(const std::vector<char>& bytes) const {
    json document = editable_document();
    folder_.write("mesh.bin", bytes);
    document["buffers"].push_back({{"byteLength", bytes.size()}, {"uri", "mesh.bin"}});
    const std::size_t view = document["bufferViews"].size();
    document["bufferViews"].push_back({{"buffer", 1}, {"byteLength", bytes.size()}});
    for (const std::size_t accessor : {0U, 1U, 2U, 3U}) document["accessors"][accessor].erase("bufferView");
    for (const std::size_t accessor : {0U, 1U, 2U}) document["accessors"][accessor]["count"] = packed_.points;
    json& primitive = document["meshes"][0]["primitives"][0];
    primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", view}, {"attributes", packed_.attributes}};
    document["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    return folder_.write("model.gltf", document.dump());
  }

  Packed packed_ = pack(GetParam());
  TemporaryFolder folder_;
};

/// The surface as what is drawn, whatever the order of vertices and triangles.
std::vector<std::string> drawn(const anim::SkinnedMesh& mesh) {
  std::vector<std::string> triangles;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    std::vector<std::string> corners;
    for (std::size_t corner = i; corner < i + 3; ++corner) {
      const std::uint32_t vertex = mesh.indices[corner];
      std::string text;
      for (int axis = 0; axis < 3; ++axis) text += std::to_string(mesh.positions[vertex][axis]) + " ";
      for (int k = 0; k < 4; ++k) {
        text += std::to_string(mesh.palette_entries[vertex][k]) + ":" + std::to_string(mesh.weights[vertex][k]) + " ";
      }
      corners.push_back(text);
    }
    std::ranges::rotate(corners, std::ranges::min_element(corners));
    triangles.push_back(corners[0] + corners[1] + corners[2]);
  }
  std::ranges::sort(triangles);
  return triangles;
}

TEST_P(PackedMesh, IsTheMeshThatWasPacked) {
  const anim::ImportedFile plain = import_good(data_path("features/data-uri.gltf"));
  const anim::ImportedFile packed = import_good(write(packed_.bytes));
  EXPECT_THAT(packed.repairs, IsEmpty());
  ASSERT_EQ(packed.models.front().meshes.size(), 1U);
  EXPECT_EQ(drawn(packed.models.front().meshes.front()), drawn(plain.models.front().meshes.front()));
}

TEST_P(PackedMesh, IsRefusedOrReadWhateverIsDamaged) {
  std::mt19937 random(20261125);
  for (int round = 0; round < 300; ++round) {
    std::vector<char> bytes = packed_.bytes;
    if (round % 5 == 0) bytes.resize(1 + random() % bytes.size());
    for (unsigned left = 1 + random() % 4; left > 0; --left)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    const std::string message = message_of(write(bytes));
    EXPECT_TRUE(message.empty() || message.find(": ") != std::string::npos) << message;
  }
}

TEST_P(PackedMesh, IsNotBelievedWhenItPromisesMoreThanItsBytesHold) {
  std::vector<char> bytes = packed_.bytes;
  const std::size_t counts = GetParam() == draco::MESH_EDGEBREAKER_ENCODING ? 12 : 11;  // after the head
  for (const char digit : {'\xFF', '\xFF', '\xFF', '\xFF', '\x07'}) {
    bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(counts), digit);
  }
  EXPECT_THAT(message_of(write(bytes)), HasSubstr("mesh 0, primitive 0: "));
  EXPECT_THAT(message_of(write(std::vector<char>(40, 'x'))), HasSubstr("its bytes are no Draco mesh"));
}

INSTANTIATE_TEST_SUITE_P(Methods, PackedMesh,
                         ::testing::Values(draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING),
                         [](const auto& instance) {
                           return instance.param == draco::MESH_EDGEBREAKER_ENCODING ? "Edgebreaker" : "Sequential";
                         });

}  // namespace
}  // namespace throng::import::testing::draco_test
