// A model out of memory: a game has its files in an archive, a download, or the assets of a mobile app.
#include <cstdio>
#include <string_view>

#include "throng/throng.h"

using namespace throng;

namespace {

/// A tip that turns a quarter and back within a second. Its keys are in a file of their own, as the model says.
constexpr std::string_view model = R"({
  "asset": {"version": "2.0"},
  "scene": 0, "scenes": [{"nodes": [0]}],
  "nodes": [{"name": "root", "children": [1]}, {"name": "tip", "translation": [0, 1, 0]}],
  "skins": [{"joints": [0, 1]}],
  "buffers": [{"uri": "keys.bin", "byteLength": 60}],
  "bufferViews": [{"buffer": 0, "byteLength": 60}],
  "accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 3, "type": "SCALAR", "min": [0], "max": [1]},
    {"bufferView": 0, "byteOffset": 12, "componentType": 5126, "count": 3, "type": "VEC4"}],
  "animations": [{"name": "nod", "samplers": [{"input": 0, "output": 1}],
    "channels": [{"sampler": 0, "target": {"node": 1, "path": "rotation"}}]}]})";

constexpr float keys[] = {0.0F, 0.5F, 1.0F,              // seconds
                          0.0F, 0.0F, 0.0F,       1.0F,  // upright
                          0.0F, 0.0F, 0.7071068F, 0.7071068F, 0.0F, 0.0F, 0.0F, 1.0F};

}  // namespace

int main() {
  const FileInMemory archive[] = {{.name = "nod.gltf", .bytes = std::as_bytes(std::span(model))},
                                  {.name = "keys.bin", .bytes = std::as_bytes(std::span(keys))}};
  const auto file = load(archive);  // reads no other file
  if (!file) return std::fprintf(stderr, "%s\n", file.error().message.c_str()), 1;
  const Character character = file->characters.front();
  const ClipInfo clip = character.clip(character.find_clip("nod"));
  std::printf("%d bones, a clip of %.1f s that %s\n", character.bone_count(), to_seconds(clip.duration),
              clip.loops ? "loops" : "ends");
}
