// Loading characters from files in memory.

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "throng/c.h"

#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/pack/pack.h"
#include "tests/anim/agent/heard_misuses.h"
#include "tests/api/api_crowd.h"

namespace throng::memory_test {
namespace {

using api_test::hash_of;
using testing::HasSubstr;

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

FileInMemory in_memory(std::string_view name, std::string_view bytes) {
  return {.name = name, .bytes = std::as_bytes(std::span(bytes))};
}

/// A triangle on two bones, whose buffer is a file of its own.
constexpr std::string_view small_gltf = R"({"asset": {"version": "2.0"},
  "buffers": [{"uri": "data/small%20one.bin", "byteLength": 36}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "nodes": [{"name": "root", "children": [1]}, {"name": "tip", "translation": [0, 1, 0]}, {"mesh": 0, "skin": 0}],
  "skins": [{"joints": [0, 1]}], "scenes": [{"nodes": [0, 2]}], "scene": 0})";
std::string small_buffer() {
  const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  return {reinterpret_cast<const char*>(corners), sizeof(corners)};
}

TEST(LoadFromMemory, GivesTheCharacterThatTheFileGives) {
  const std::string bytes = bytes_of(THRONG_SOURCE_DIR "/assets/mannequin.glb");
  const FileInMemory file = in_memory("man.glb", bytes);
  const auto loaded = load({&file, 1}, {.keep_meshes = true});
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(hash_of(loaded->characters.front()), hash_of(api_test::mannequin()));
  EXPECT_EQ(loaded->characters.front().mesh_count(), api_test::mannequin().mesh_count());
}

TEST(LoadFromMemory, FindsTheFilesThatAModelNames) {
  const std::string buffer = small_buffer();
  const FileInMemory both[] = {in_memory("small.gltf", small_gltf), in_memory("data/small one.bin", buffer)};
  const auto loaded = load(both);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->characters.front().bone_count(), 2);
}

TEST(LoadFromMemory, ReadsNoFileOfTheDisk) {
  const FileInMemory alone = in_memory(THRONG_SOURCE_DIR "/assets/small.gltf", small_gltf);
  const auto loaded = load({&alone, 1});
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().message, HasSubstr("small.gltf: "));
  EXPECT_THAT(loaded.error().message, HasSubstr("no file in memory is named \"data/small one.bin\""));
}

TEST(LoadFromMemory, OpensAPackWhoseBytesMayGo) {
  pack::FileToPack file{.name = "small", .file = {}, .characters = {}};
  file.file.models = {anim::synthetic_model(5, 2)};
  auto baked = std::make_shared<const anim::Character>(anim::bake_character(file.file.models.front()));
  file.characters.push_back({.name = "small", .prepared = {}, .character = std::move(baked), .surface = {}});
  std::vector<std::byte> bytes = pack::write_pack({&file, 1});
  bytes.insert(bytes.begin(), std::byte{0});  // the pack lies on an odd address
  const FileInMemory in_a_host{.name = "people.bin", .bytes = std::span(bytes).subspan(1)};
  const auto loaded = load({&in_a_host, 1});
  ASSERT_TRUE(loaded) << loaded.error().message;
  std::ranges::fill(bytes, std::byte{0xCD});
  EXPECT_NE(hash_of(loaded->characters.front()), 0U);
  const FileInMemory spoiled{.name = "people.pack", .bytes = bytes};
  EXPECT_THAT(load({&spoiled, 1}).error().message, HasSubstr("people.pack: it is no pack"));
}

TEST(LoadFromMemory, OfNothingIsAMisuseAndOfNoBytesAnError) {
  const anim::HeardMisuses heard;
  EXPECT_FALSE(load(std::span<const FileInMemory>()));
  EXPECT_EQ(anim::HeardMisuses::all().size(), 1U);
  const FileInMemory empty{.name = "empty.glb"};
  EXPECT_THAT(load({&empty, 1}).error().message, HasSubstr("empty.glb: it is empty"));
}

TEST(LoadFromMemory, ServesCToo) {
  const std::string bytes = bytes_of(THRONG_SOURCE_DIR "/assets/mannequin.glb");
  throng_file* const file = throng_load_bytes("man.glb", bytes.data(), bytes.size(), 0.0);
  ASSERT_NE(file, nullptr) << throng_last_error();
  EXPECT_EQ(throng_file_character_count(file), 1U);
  throng_file_free(file);
  EXPECT_EQ(throng_load_bytes("half.glb", bytes.data(), bytes.size() / 2, 0.0), nullptr);
  EXPECT_THAT(throng_last_error(), HasSubstr("half.glb: "));
}

}  // namespace
}  // namespace throng::memory_test
