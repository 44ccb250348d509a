#include "tests/faults/jobs.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>

#include <nlohmann/json.hpp>

namespace throng::test {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// Takes a .glb apart into a .gltf, its buffer and a picture, so that a model is three files.
void write_model(const fs::path& model) {
  const fs::path data = THRONG_SOURCE_DIR "/tests/data";
  const std::string glb = read(data / "features/weights-u8.glb");
  constexpr std::size_t header = 12, chunk_header = 8;
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + header, sizeof(length));
  auto json = nlohmann::json::parse(glb.substr(header + chunk_header, length));
  json["buffers"][0]["uri"] = "model.bin";
  json["images"] = {{{"uri", "skin.png"}}};
  json["textures"] = {{{"source", 0}}};
  json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  json["meshes"][0]["primitives"][0]["material"] = 0;
  std::ofstream(model) << json.dump();
  std::ofstream(model.parent_path() / "model.bin", std::ios::binary) << glb.substr(header + 2 * chunk_header + length);
  fs::copy_file(data / "fuzz/image/rgba.png", model.parent_path() / "skin.png", fs::copy_options::overwrite_existing);
}

}  // namespace

std::vector<Job> jobs_in(const fs::path& folder) {
  const fs::path model = folder / "model.gltf";
  write_model(model);
  const auto at = [&](const char* name) { return (folder / name).string(); };
  return {
      {.name = "run",
       .arguments = {model, "--headless=none", "--agents", "6", "--frames", "2", "--pus", "2", "--record",
                     at("run.rec"), "--stats", at("run.json"), "--trace", at("trace.json")},
       .outputs = {at("run.rec"), at("run.json"), at("trace.json")}},
      {.name = "picture",
       .arguments = {model, "--headless=" THRONG_HEADLESS, "--agents", "2", "--frames", "1", "--size", "64x64", "--ui",
                     "--ui-map", at("map.json"), "--screenshot", at("picture.png")},
       .outputs = {at("map.json"), at("picture.png")}},
      {.name = "compare",
       .arguments = {"compare", folder / "skin.png", folder / "skin.png", "--difference", at("difference.png")},
       .outputs = {at("difference.png")}},
      {.name = "bake",
       .arguments = {"bake", model, "--keep-keys", "-o", at("model.pack")},
       .outputs = {at("model.pack")}},
      {.name = "inspect", .arguments = {"inspect", model, "--json"}, .outputs = {}},
      {.name = "pose",
       .arguments = {"pose", model, "--clip", "0", "--time", "0,0.5", "--json", at("pose.json")},
       .outputs = {at("pose.json")}},
      {.name = "lod",
       .arguments = {"lod", model, "--json", at("lod.json"), "--plot", at("lod.svg"), "--export", at("export.json")},
       .outputs = {at("lod.json"), at("lod.svg"), at("export.json")}},
      {.name = "bench",
       .arguments = {"bench", "--agents", "4", "--bones", "8", "--frames", "1", "--pus", "2", "--json",
                     at("bench.json"), "--trace", at("bench.trace.json")},
       .outputs = {at("bench.json"), at("bench.trace.json")}},
  };
}

}  // namespace throng::test
