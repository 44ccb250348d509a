// Morph targets that animations move.
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/morph_limits.h"
#include "engine/anim/asset/reference_pose.h"
#include "tests/import/test_files.h"

namespace throng::import::testing::morphs_test {
namespace {

using nlohmann::json;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr std::size_t vertices = 44;
constexpr int body = 6;  // the node that draws the mesh

/// The feature with morph targets, whose numbers lie in a buffer of their own.
class MorphFile {
 public:
  json document = editable_document();

  json& mesh() { return document["meshes"][0]; }
  json& primitive() { return mesh()["primitives"][0]; }
  json& animation() { return document["animations"][0]; }

  std::size_t add_numbers(const std::vector<float>& numbers, const std::string& type, std::size_t count) {
    json& views = document["bufferViews"];
    views.push_back({{"buffer", 1}, {"byteOffset", bytes_.size()}, {"byteLength", numbers.size() * sizeof(float)}});
    const auto* const from = reinterpret_cast<const char*>(numbers.data());
    bytes_.insert(bytes_.end(), from, from + numbers.size() * sizeof(float));
    json accessor = {{"componentType", 5126}, {"count", count}, {"type", type}, {"bufferView", views.size() - 1}};
    if (type == "SCALAR") accessor.update({{"min", {numbers.front()}}, {"max", {numbers.back()}}});
    document["accessors"].push_back(accessor);
    return document["accessors"].size() - 1;
  }

  /// Adds a target that moves one vertex.
  void add_target(std::size_t vertex, const glm::vec3& offset) {
    std::vector<float> numbers(vertices * 3, 0.0F);
    for (std::size_t axis = 0; axis < 3; ++axis) numbers[vertex * 3 + axis] = offset[static_cast<int>(axis)];
    primitive()["targets"].push_back({{"POSITION", add_numbers(numbers, "VEC3", vertices)}});
  }

  /// Adds a channel of weights with keys at `times`.
  void animate(const std::vector<float>& times, const std::vector<float>& weights,
               const std::string& interpolation = "LINEAR", int node = body) {
    const std::size_t input = add_numbers(times, "SCALAR", times.size());
    const std::size_t output = add_numbers(weights, "SCALAR", weights.size());
    document["accessors"][output].erase("min");
    document["accessors"][output].erase("max");
    animation()["channels"].push_back(
        {{"sampler", animation()["samplers"].size()}, {"target", {{"node", node}, {"path", "weights"}}}});
    animation()["samplers"].push_back({{"input", input}, {"output", output}, {"interpolation", interpolation}});
  }

  std::filesystem::path write() {
    document["buffers"].push_back({{"byteLength", bytes_.size()}, {"uri", "morphs.bin"}});
    folder_.write("morphs.bin", bytes_);
    return folder_.write("morphs.gltf", document.dump());
  }
  anim::ImportedFile import() { return import_good(write()); }

 private:
  std::vector<char> bytes_;
  TemporaryFolder folder_;
};

const anim::MorphTrack& track_of(const anim::Model& model) { return model.clips.front().morph_tracks.front(); }

TEST(Morphs, KeepWhatAnimatedTargetsDoToTheVerticesThatTheyMove) {
  MorphFile file;
  for (const std::size_t vertex : {3U, 7U, 3U})
    file.add_target(vertex, {0.0F, 0.1F * static_cast<float>(vertex), 0.0F});
  file.mesh()["extras"]["targetNames"] = {"smile", "frown", "blink"};
  file.animate({0.0F, 1.5F}, {0, 0, 0, 1, 0, 0.5F});  // the second stays at rest
  const anim::ImportedFile imported = file.import();
  EXPECT_THAT(imported.repairs, IsEmpty());
  const anim::Model& model = imported.models.front();
  ASSERT_THAT(model.morphs, SizeIs(2));
  EXPECT_EQ(model.morphs[0].name, "mesh 0, target 0 \"smile\"");
  EXPECT_EQ(model.morphs[1].name, "mesh 0, target 2 \"blink\"");
  EXPECT_EQ(track_of(model).morphs, (std::vector<int>{0, 1}));
  EXPECT_EQ(track_of(model).weights, (std::vector<float>{0, 0, 1, 0.5F}));
  const anim::SkinnedMesh& mesh = model.meshes.front();
  const glm::mat3 bind(model.skins.front().bind_to_model);
  ASSERT_GE(mesh.morph_deltas.size(), 2U);
  for (const anim::MorphDelta& delta : mesh.morph_deltas) {
    EXPECT_LT(glm::distance(delta.position, bind * glm::vec3(0.0F, 0.3F, 0.0F)), 1e-6F);
    EXPECT_EQ(mesh.positions[delta.vertex], mesh.positions[mesh.morph_deltas.front().vertex])
        << "the copies that flat shading made of vertex 3, and no other";
  }
  const auto copies = std::ranges::count(mesh.positions, mesh.positions[mesh.morph_deltas.front().vertex]);
  EXPECT_EQ(mesh.morph_deltas.size(), static_cast<std::size_t>(2 * copies)) << "both morphs move each copy";
}

TEST(Morphs, CountFromTheWeightsThatTheSurfaceRestsAt) {
  MorphFile file;
  file.add_target(3, {0.0F, 1.0F, 0.0F});
  file.add_target(3, {1.0F, 0.0F, 0.0F});
  file.mesh()["weights"] = {0.25, 0.5};
  file.animate({0.0F, 1.0F}, {0.25F, 0.5F, 1.0F, 0.5F});
  const anim::Model model = file.import().models.front();
  ASSERT_THAT(model.morphs, SizeIs(1)) << "a target that keeps its weight is part of the surface alone";
  EXPECT_EQ(model.morphs[0].rest_weight, 0.25);
  EXPECT_THAT(track_of(model).weights, ElementsAre(0.0F, 0.75F));
}

TEST(Morphs, OfASplineKeepTheirTangentsAsTheyAre) {
  MorphFile file;
  file.add_target(3, {0.0F, 1.0F, 0.0F});
  file.mesh()["weights"] = {0.5};
  file.animate({0.0F, 1.0F}, {1, 0.5F, 2, 3, 1, 4}, "CUBICSPLINE");
  const anim::Model model = file.import().models.front();
  EXPECT_EQ(track_of(model).interpolation, anim::Interpolation::cubic_spline);
  EXPECT_THAT(track_of(model).weights, ElementsAre(1.0F, 0.0F, 2.0F, 3.0F, 0.5F, 4.0F));
}

TEST(Morphs, TurnNormalsByAsMuchAsUnitNormalsTurn) {
  MorphFile file;
  file.primitive()["attributes"]["NORMAL"] = file.add_numbers(
      [] {
        std::vector<float> up(vertices * 3, 0.0F);
        for (std::size_t i = 1; i < up.size(); i += 3) up[i] = 1.0F;
        return up;
      }(),
      "VEC3", vertices);
  std::vector<float> turns(vertices * 3, 0.0F);
  turns[3 * 3 + 1] = 1.0F;  // resting at 1 it makes the normal twice as long
  turns[3 * 3 + 2] = 0.5F;
  const std::size_t turned = file.add_numbers(turns, "VEC3", vertices);
  file.add_target(3, {0.0F, 1.0F, 0.0F});
  file.primitive()["targets"][0]["NORMAL"] = turned;
  file.mesh()["weights"] = {1.0};
  file.animate({0.0F, 1.0F}, {1, 2});
  const anim::Model model = file.import().models.front();
  const anim::SkinnedMesh& mesh = model.meshes.front();
  ASSERT_THAT(mesh.morph_deltas, SizeIs(1));
  const glm::vec3 rest(0.0F, 2.0F, 0.5F), turn(0.0F, 1.0F, 0.5F);
  const glm::mat3 bind(glm::mat3(model.skins.front().bind_to_model));
  const float scale = glm::length(bind[0]);
  const anim::MorphDelta& delta = mesh.morph_deltas.front();
  EXPECT_LT(glm::distance(delta.normal, bind * turn / scale / glm::length(rest)), 1e-5F);
  EXPECT_LT(glm::distance(glm::normalize(mesh.normals[3] + delta.normal), glm::normalize(bind * (rest + turn))), 1e-5F);
}

TEST(Morphs, OfAMeshThatAJointCarriesAreKeptInThatPlace) {
  MorphFile file;
  json& nodes = file.document["nodes"];
  const auto hat = static_cast<int>(nodes.size());
  nodes[5]["children"].push_back(hat);
  nodes.push_back({{"mesh", 1}, {"scale", {2.0, 2.0, 2.0}}, {"translation", {0.0, 1.0, 0.0}}});
  file.add_target(3, {0.0F, 0.5F, 0.0F});
  file.document["meshes"].push_back({{"primitives", json::array({file.primitive()})}});
  file.primitive().erase("targets");
  json& attributes = file.document["meshes"][1]["primitives"][0]["attributes"];
  attributes.erase("JOINTS_0");
  attributes.erase("WEIGHTS_0");
  file.animate({0.0F, 1.0F}, {0, 1}, "LINEAR", hat);
  const anim::Model model = file.import().models.front();
  ASSERT_THAT(model.meshes, SizeIs(2));
  EXPECT_THAT(model.meshes[0].morph_deltas, IsEmpty());
  ASSERT_THAT(model.morphs, SizeIs(1));
  EXPECT_EQ(model.morphs[0].node, hat);
  ASSERT_FALSE(model.meshes[1].morph_deltas.empty());
  const anim::SkinnedMesh& mesh = model.meshes[1];
  const anim::MorphDelta& delta = mesh.morph_deltas.front();
  const glm::dmat4 entry =
      anim::reference_pose(model.skeleton, nullptr, 0.0).palette[mesh.palette_entries[delta.vertex].x];
  EXPECT_NEAR(glm::length(glm::dmat3(entry) * glm::dvec3(delta.position)), 1.0, 1e-5) << "its node is twice as large";
}

TEST(Morphs, MakeAClipOfAnAnimationThatMovesNothingElse) {
  MorphFile file;
  file.add_target(3, {0.0F, 1.0F, 0.0F});
  json& animations = file.document["animations"];
  const json smile = {{"name", "smile"}, {"channels", json::array()}, {"samplers", json::array()}};
  animations.insert(animations.begin(), smile);
  file.animate({0.25F, 0.75F}, {0, 1});
  const anim::Model model = file.import().models.front();
  ASSERT_THAT(model.clips, SizeIs(2));
  EXPECT_EQ(model.clips[0].name, "smile");
  EXPECT_EQ(model.clips[0].animation, 0);
  EXPECT_EQ(model.clips[0].start, 0.25);
  EXPECT_THAT(model.clips[0].tracks, IsEmpty());
  EXPECT_THAT(model.clips[1].morph_tracks, IsEmpty());
}

TEST(Morphs, KeepTheStrongestOfTooManyAndSaySo) {
  MorphFile file;
  const std::size_t count = anim::most_morphs + 3;
  for (std::size_t target = 0; target < count; ++target) {
    file.add_target(3, {0.0F, 0.01F * static_cast<float>(count - target), 0.0F});
  }
  std::vector<float> weights(count, 0.0F);
  weights.resize(2 * count, 1.0F);
  file.animate({0.0F, 1.0F}, weights);
  const anim::ImportedFile imported = file.import();
  EXPECT_THAT(imported.models.front().morphs, SizeIs(anim::most_morphs));
  EXPECT_THAT(imported.repairs, Contains(HasSubstr("the strongest 64 are kept; left out: mesh 0, target 64; mesh 0")));
  for (const anim::MorphDelta& delta : imported.models.front().meshes.front().morph_deltas) {
    EXPECT_LT(delta.morph, anim::most_morphs);
  }
}

TEST(Morphs, LeaveOutWhatIsNoNumberAndSaySo) {
  MorphFile file;
  file.add_target(3, {0.0F, 1.0F, 0.0F});
  file.add_target(4, {0.0F, std::numeric_limits<float>::quiet_NaN(), 0.0F});
  file.animate({0.0F, 1.0F}, {0, 0, 1, 1});
  const anim::ImportedFile imported = file.import();
  EXPECT_THAT(imported.models.front().morphs, SizeIs(1));
  EXPECT_THAT(imported.repairs, Contains(HasSubstr("1 displacements of morph targets are no numbers, left out")));
}

TEST(Morphs, OfANodeWithoutTargetsAreLeftOutAndNamed) {
  MorphFile file;
  file.animate({0.0F, 1.0F}, {0, 1});
  const anim::ImportedFile imported = file.import();
  EXPECT_THAT(imported.models.front().morphs, IsEmpty());
  EXPECT_THAT(imported.repairs, Contains(HasSubstr("\"wave\", channel 5: weights of a node without morph targets")));
}

TEST(Morphs, WithWeightsBeyondAllMeasureAreRefused) {
  for (const float weight : {2e4F, -std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    MorphFile file;
    file.add_target(3, {0.0F, 1.0F, 0.0F});
    file.animate({0.0F, 1.0F}, {0, weight});
    EXPECT_THAT(message_of(file.write()), HasSubstr("a weight of a morph target is no number, or beyond 10,000"));
  }
}

TEST(Morphs, WithAnotherNumberOfWeightsAreRefused) {
  MorphFile file;
  file.add_target(3, {0.0F, 1.0F, 0.0F});
  file.add_target(4, {0.0F, 1.0F, 0.0F});
  file.animate({0.0F, 1.0F}, {0, 1});
  EXPECT_THAT(message_of(file.write()), HasSubstr("channel 5: has 2 weights for 2 key times of 2 morph targets"));
}

}  // namespace
}  // namespace throng::import::testing::morphs_test
