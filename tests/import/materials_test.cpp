#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/import/import.h"
#include "tests/import/test_files.h"

namespace throng::import::testing::materials_test {
namespace {

using nlohmann::json;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// Two texels each: red, and a blue of half the alpha.
constexpr const char* png =
    "data:image/"
    "png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAADklEQVR42mP4z8AAQg0AD3oDfmqBMeEAAAAASUVORK5CYII=";
constexpr const char* webp = "data:image/webp;base64,UklGRiAAAABXRUJQVlA4TBMAAAAvAQAAEA8Q+z//D/yPChWI6H8AAA==";
constexpr const char* ktx2 = "data:image/ktx2;base64,q0tUWCAyMLsNChoK";
const std::vector<std::uint8_t> red_and_blue{255, 0, 0, 255, 0, 0, 255, 128};

/// A skinned primitive with one material, one texture that shows `image`, and two sets of texture coordinates.
json document_with(const json& material, const std::string& image = png) {
  json document = read_json(data_path("features/data-uri.gltf"));
  const std::size_t accessor = document["accessors"].size();
  const json zeros = {{"componentType", 5126}, {"count", 44}, {"type", "VEC2"}};
  json numbers = zeros;
  numbers["bufferView"] = 0;
  document["accessors"].insert(document["accessors"].end(), {zeros, numbers});
  json& primitive = document["meshes"][0]["primitives"][0];
  primitive["attributes"]["TEXCOORD_0"] = accessor;
  primitive["attributes"]["TEXCOORD_1"] = accessor + 1;
  primitive["material"] = 0;
  document["materials"] = json::array({material});
  document["textures"] = json::array({json::object({{"source", 0}})});
  document["images"] = json::array({json::object({{"uri", image}})});
  return document;
}

json with_base_texture(const json& reference) { return {{"pbrMetallicRoughness", {{"baseColorTexture", reference}}}}; }

anim::ImportedFile imported(const json& document) {
  const TemporaryFolder folder;
  return import_good(folder.write("model.gltf", document.dump()));
}

anim::Material material_of(const json& document) { return imported(document).models.at(0).materials.at(0); }

TEST(Materials, ShineAsStronglyAsTheirExtensionSays) {
  const json strength = {{"KHR_materials_emissive_strength", {{"emissiveStrength", 3.0}}}};
  const anim::Material material = material_of(document_with(
      {{"emissiveFactor", {1.0, 0.5, 0.0}}, {"emissiveTexture", {{"index", 0}}}, {"extensions", strength}}));
  EXPECT_EQ(material.emission, glm::vec3(3.0F, 1.5F, 0.0F));
  EXPECT_EQ(material.emission_texture.image, 0);
  EXPECT_EQ(material.base_color_texture.image, -1);
}

TEST(Materials, ThatDoNotShineNeedNoTextureForIt) {
  EXPECT_EQ(material_of(document_with({{"emissiveTexture", {{"index", 0}}}})).emission_texture.image, -1);
}

anim::ImportedFile of_specular_glossiness(const json& extension, json material = json::object()) {
  material["extensions"] = {{"KHR_materials_pbrSpecularGlossiness", extension}};
  return imported(document_with(material));
}

TEST(Materials, OfSpecularGlossinessHaveTheirDiffuseColor) {
  const json extension = {{"diffuseFactor", {0.5, 0.25, 1.0, 0.75}},
                          {"diffuseTexture", {{"index", 0}}},
                          {"specularFactor", {0.04, 0.04, 0.04}},
                          {"glossinessFactor", 0.25}};
  const anim::ImportedFile file = of_specular_glossiness(extension);
  const anim::Material& material = file.models.at(0).materials.at(0);
  EXPECT_EQ(material.base_color, glm::vec4(0.5F, 0.25F, 1.0F, 0.75F));
  EXPECT_EQ(material.base_color_texture.image, 0);
  EXPECT_EQ(material.metallic, 0.0F);
  EXPECT_EQ(material.roughness, 0.75F);
  EXPECT_THAT(file.models.at(0).images, SizeIs(1)) << "which need no conversion";
}

TEST(Materials, OfSpecularGlossinessThatAreMetalHaveTheirSpecularColor) {
  const json extension = {{"diffuseFactor", {0, 0, 0, 1}}, {"specularFactor", {1.0, 0.5, 0.25}}};
  const anim::ImportedFile file = of_specular_glossiness(extension);
  const anim::Material& material = file.models.at(0).materials.at(0);
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(material.base_color[c], glm::vec4(1.0F, 0.5F, 0.25F, 1.0F)[c], 1e-4F);
  EXPECT_NEAR(material.metallic, 1.0F, 1e-4F);
}

TEST(Materials, OfSpecularGlossinessInATextureAreConvertedTexelByTexel) {
  // A mirror of red light, and a blue one of which half the alpha is glossy.
  const json extension = {{"diffuseFactor", {0, 0, 0, 1}}, {"specularGlossinessTexture", {{"index", 0}}}};
  const anim::ImportedFile file = of_specular_glossiness(extension);
  const anim::Model& model = file.models.at(0);
  const anim::Material& material = model.materials.at(0);
  ASSERT_THAT(model.images, SizeIs(2)) << "not the one of the file";
  const anim::Image& colors = model.images.at(static_cast<std::size_t>(material.base_color_texture.image));
  const anim::Image& numbers = model.images.at(static_cast<std::size_t>(material.metallic_roughness_texture.image));
  EXPECT_THAT(colors.rgba, ElementsAre(255, 0, 0, 255, 0, 0, 255, 255));
  EXPECT_THAT(numbers.rgba, ElementsAre(255, 0, 255, 255, 255, 127, 255, 255)) << "green is 1 - alpha, blue metal";
  EXPECT_EQ(material.roughness, 1.0F);
  EXPECT_EQ(material.metallic, 1.0F);
}

TEST(Materials, OfBothKindsAreReadAsMetallicAndRough) {
  const json both = {
      {"pbrMetallicRoughness", {{"roughnessFactor", 0.5}, {"metallicRoughnessTexture", {{"index", 0}}}}}};
  const anim::ImportedFile file = of_specular_glossiness({{"glossinessFactor", 0.0}}, both);
  EXPECT_EQ(file.models.at(0).materials.at(0).roughness, 0.5F);
  EXPECT_EQ(file.models.at(0).materials.at(0).metallic_roughness_texture.image, 0);
}

TEST(Materials, KeepWhatTheLightReads) {
  const anim::Material material = material_of(document_with(
      {{"pbrMetallicRoughness",
        {{"metallicFactor", 0.25}, {"roughnessFactor", 0.5}, {"metallicRoughnessTexture", {{"index", 0}}}}},
       {"normalTexture", {{"index", 0}, {"scale", 2.0}}},
       {"occlusionTexture", {{"index", 0}, {"strength", 0.5}, {"texCoord", 1}}}}));
  EXPECT_EQ(material.metallic, 0.25F);
  EXPECT_EQ(material.roughness, 0.5F);
  EXPECT_EQ(material.metallic_roughness_texture.image, 0);
  EXPECT_EQ(material.normal_scale, 2.0F);
  EXPECT_EQ(material.normal_texture.image, 0);
  EXPECT_EQ(material.occlusion_strength, 0.5F);
  EXPECT_NE(material.occlusion_texture.coords, material.normal_texture.coords) << "another set";
}

TEST(Materials, SayWhetherTheyAreUnlitBlendedOrCutOut) {
  const anim::Material unlit = material_of(document_with({{"extensions", {{"KHR_materials_unlit", json::object()}}}}));
  EXPECT_TRUE(unlit.unlit);
  const anim::Material blended = material_of(document_with({{"alphaMode", "BLEND"}}));
  EXPECT_TRUE(blended.blended && !blended.unlit);
  EXPECT_EQ(material_of(document_with({{"alphaMode", "MASK"}})).alpha_cutoff, 0.5F) << "the default";
}

TEST(Materials, OfABrokenKindAreRefused) {
  for (const json& broken :
       {json{{"emissiveTexture", {{"index", 7}}}}, json{{"emissiveFactor", {1, 2}}},
        json{{"extensions", {{"KHR_materials_pbrSpecularGlossiness", {{"diffuseTexture", 1}}}}}}}) {
    const TemporaryFolder folder;
    EXPECT_FALSE(import_file(folder.write("model.gltf", document_with(broken).dump()).string())) << broken;
  }
}

TEST(Textures, ReadTheSetOfCoordinatesThatTheyName) {
  const anim::Model first = imported(document_with(with_base_texture({{"index", 0}}))).models.at(0);
  EXPECT_THAT(first.meshes.at(0).texture_coords.at(0), ::testing::Each(glm::vec2(0.0F)));
  const anim::Model second = imported(document_with(with_base_texture({{"index", 0}, {"texCoord", 1}}))).models.at(0);
  EXPECT_THAT(second.meshes.at(0).texture_coords.at(0), Contains(::testing::Ne(glm::vec2(0.0F))));
}

TEST(Textures, AreMovedByTheirTransformWhichMayNameAnotherSet) {
  const json transform = {{"offset", {0.25, 0.5}}, {"texCoord", 1}, {"scale", {0, 0}}};
  const json reference = {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}};
  json document = document_with(with_base_texture(reference));
  document["meshes"][0]["primitives"][0]["attributes"].erase("TEXCOORD_0");
  const anim::ImportedFile file = imported(document);
  EXPECT_THAT(file.repairs, IsEmpty()) << "set 0 is not read";
  EXPECT_THAT(file.models.at(0).meshes.at(0).texture_coords.at(0), ::testing::Each(glm::vec2(0.25F, 0.5F)));
}

TEST(Textures, WithoutTheirCoordinatesAreReported) {
  const anim::ImportedFile file = imported(document_with(with_base_texture({{"index", 0}, {"texCoord", 4}})));
  EXPECT_THAT(file.repairs, ElementsAre(HasSubstr("has no TEXCOORD_4, so its texture shows one colour")));
  EXPECT_THAT(file.models.at(0).meshes.at(0).texture_coords.at(0), IsEmpty());
}

TEST(Textures, WrapAndFilterAsTheirSamplerSays) {
  json document = document_with(with_base_texture({{"index", 0}}));
  document["samplers"] = json::array({{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9984}}});
  document["textures"][0]["sampler"] = 0;
  const anim::Texture texture = material_of(document).base_color_texture;
  EXPECT_EQ(texture.wrap_u, anim::Wrap::clamp);
  EXPECT_EQ(texture.wrap_v, anim::Wrap::mirror);
  EXPECT_EQ(texture.magnified, anim::Filter::nearest);
  EXPECT_EQ(texture.minified, anim::Filter::nearest_of_nearest);
}

TEST(Textures, WhoseSamplerHasAnUnknownNumberRepeatAndSaySo) {
  json document = document_with(with_base_texture({{"index", 0}}));
  document["samplers"] = json::array({json::object({{"wrapS", 7}})});
  document["textures"][0]["sampler"] = 0;
  const anim::ImportedFile file = imported(document);
  EXPECT_THAT(file.repairs, ElementsAre(HasSubstr("sampler 0: a filter or wrap of it is unknown")));
  EXPECT_EQ(file.models.at(0).materials.at(0).base_color_texture.wrap_u, anim::Wrap::repeat);
}

TEST(Images, AreDecodedByWhatTheyAre) {
  for (const char* image : {png, webp}) {
    const anim::ImportedFile file = imported(document_with(with_base_texture({{"index", 0}}), image));
    EXPECT_THAT(file.repairs, IsEmpty());
    ASSERT_THAT(file.models.at(0).images, SizeIs(1));
    EXPECT_THAT(file.models.at(0).images[0].rgba, ElementsAreArray(red_and_blue));
  }
}

TEST(Images, InWebPMayBeRequired) {
  json document = document_with(with_base_texture({{"index", 0}}), webp);
  document["extensionsRequired"] = json::array({"EXT_texture_webp"});
  document["textures"][0] = {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}};
  EXPECT_THAT(imported(document).models.at(0).images, SizeIs(1));
}

TEST(Images, BesideABrokenOneAreShownInItsPlace) {
  json document = document_with(with_base_texture({{"index", 0}}), "missing.webp");
  document["images"].push_back(json::object({{"uri", png}}));
  document["textures"][0] = {{"source", 1}, {"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}};
  const anim::ImportedFile file = imported(document);
  EXPECT_THAT(file.models.at(0).images, SizeIs(1));
  EXPECT_THAT(file.repairs,
              ElementsAre(HasSubstr("image 0 \"missing.webp\": left out, because there is no file \"missing.webp\"")));
}

TEST(Images, InKtx2AreReplacedByThePngBesideThem) {
  json document = document_with(with_base_texture({{"index", 0}}));
  document["images"].push_back(json::object({{"uri", ktx2}}));
  document["extensionsRequired"] = json::array({"KHR_texture_basisu"});
  document["textures"][0]["extensions"] = {{"KHR_texture_basisu", {{"source", 1}}}};
  const anim::ImportedFile file = imported(document);
  EXPECT_THAT(file.repairs, IsEmpty());
  EXPECT_EQ(file.models.at(0).materials.at(0).base_color_texture.image, 0);
}

TEST(Images, InKtx2AloneLeaveTheBaseColorAndSaySo) {
  json document = document_with(with_base_texture({{"index", 0}}), ktx2);
  document["textures"][0] = {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}};
  const anim::ImportedFile file = imported(document);
  EXPECT_THAT(file.repairs, ElementsAre(HasSubstr("texture 0: has KTX2, which is not decoded, and no PNG or JPEG")));
  EXPECT_EQ(file.models.at(0).materials.at(0).base_color_texture.image, -1);
  document["textures"][0] = json::object({{"source", 0}});
  EXPECT_THAT(imported(document).repairs, ElementsAre(HasSubstr("it is KTX2, which is not decoded")));
}

}  // namespace
}  // namespace throng::import::testing::materials_test
