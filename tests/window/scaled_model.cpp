#include "tests/window/scaled_model.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

#include <nlohmann/json.hpp>

namespace throng::app {
namespace {

// A GLB file: 12 bytes of header, then chunks of 8 bytes of header and their bytes, the JSON first (glTF 2.0, 4.4).
constexpr std::size_t total_at = 8, json_length_at = 12, json_at = 20, alignment = 4;

std::uint32_t number_at(const std::string& bytes, std::size_t place) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + place, sizeof number);
  return number;
}

void put_number(std::string& bytes, std::size_t place, std::size_t number) {
  const auto written = static_cast<std::uint32_t>(number);
  std::memcpy(bytes.data() + place, &written, sizeof written);
}

}  // namespace

void write_scaled_mannequin(const std::filesystem::path& file, double times) {
  std::ifstream in(THRONG_SOURCE_DIR "/assets/mannequin.glb", std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const std::size_t length = number_at(bytes, json_length_at);
  nlohmann::json json = nlohmann::json::parse(bytes.substr(json_at, length));
  nlohmann::json& roots = json["scenes"][0]["nodes"];
  json["nodes"].push_back({{"children", roots}, {"scale", {times, times, times}}});
  roots = {json["nodes"].size() - 1};
  std::string text = json.dump();
  text.resize((text.size() + alignment - 1) / alignment * alignment, ' ');
  bytes.replace(json_at, length, text);
  put_number(bytes, json_length_at, text.size());
  put_number(bytes, total_at, bytes.size());
  std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace throng::app
