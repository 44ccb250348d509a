#include "tests/assets/character_file.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace throng::test {
namespace {

std::uint32_t word_at(const std::vector<std::byte>& bytes, std::size_t offset) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof(word));
  return word;
}

template <typename Number>
double number_at(const std::byte* place) {
  Number number{};
  std::memcpy(&number, place, sizeof(number));
  return static_cast<double>(number);
}

std::size_t components(const std::string& type) {
  if (type == "SCALAR") return 1;
  if (type == "VEC2") return 2;
  if (type == "VEC3") return 3;
  return type == "VEC4" ? 4 : 16;
}

glm::dvec3 vector_at(const std::vector<double>& values, std::size_t index) {
  return {values[3 * index], values[3 * index + 1], values[3 * index + 2]};
}

glm::dquat quaternion_at(const std::vector<double>& values, std::size_t index) {
  return {values[4 * index + 3], values[4 * index], values[4 * index + 1], values[4 * index + 2]};
}

}  // namespace

std::vector<std::byte> CharacterFile::read(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::vector<char> text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  std::vector<std::byte> bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  return bytes;
}

CharacterFile CharacterFile::committed() {
  return CharacterFile(read(std::filesystem::path(THRONG_SOURCE_DIR) / "assets" / "mannequin.glb"));
}

CharacterFile::CharacterFile(std::vector<std::byte> bytes) : bytes_(std::move(bytes)) {
  constexpr std::size_t header = 12;
  constexpr std::size_t chunk_header = 8;
  if (bytes_.size() < header + chunk_header) throw std::runtime_error("no binary glTF file");
  const std::size_t json_size = word_at(bytes_, header);
  const char* text = reinterpret_cast<const char*>(bytes_.data() + header + chunk_header);
  json_ = nlohmann::json::parse(text, text + json_size);
  buffer_start_ = header + chunk_header + json_size + chunk_header;
}

std::vector<double> CharacterFile::values(std::size_t accessor) const {
  const auto& described = json_["accessors"][accessor];
  const auto& view = json_["bufferViews"][described["bufferView"].get<std::size_t>()];
  const auto type = described["componentType"].get<int>();
  const std::size_t size = type == 5126 ? 4 : (type == 5123 ? 2 : 1);
  const std::size_t count = described["count"].get<std::size_t>() * components(described["type"]);
  const std::byte* place = bytes_.data() + buffer_start_ + view["byteOffset"].get<std::size_t>();
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i, place += size) {
    numbers.push_back(size == 4   ? number_at<float>(place)
                      : size == 2 ? number_at<std::uint16_t>(place)
                                  : number_at<std::uint8_t>(place));
  }
  return numbers;
}

std::vector<double> CharacterFile::attribute(const std::string& name) const {
  return values(primitive()["attributes"].at(name).get<std::size_t>());
}

std::vector<std::string> CharacterFile::joint_names() const {
  std::vector<std::string> names;
  for (const auto& node : json_["skins"][0]["joints"]) names.push_back(json_["nodes"][node.get<std::size_t>()]["name"]);
  return names;
}

std::vector<std::string> clip_names(const CharacterFile& file) {
  std::vector<std::string> names;
  for (const auto& animation : file.json()["animations"]) names.push_back(animation["name"]);
  return names;
}

Playback::Playback(const CharacterFile& file, const std::string& clip)
    : names_(file.joint_names()),
      parents_(names_.size(), 0),
      joints_(file.attribute("JOINTS_0")),
      weights_(file.attribute("WEIGHTS_0")) {
  for (std::size_t node = 0; node < names_.size(); ++node) {
    const auto& described = file.json()["nodes"][node];
    const auto offset = described.value("translation", std::vector<double>{0, 0, 0});
    offsets_.emplace_back(offset[0], offset[1], offset[2]);
    for (const auto& child : described.value("children", std::vector<std::size_t>{})) parents_[child] = node;
    places_.push_back(offsets_[node] + (node > 0 ? places_[parents_[node]] : glm::dvec3(0)));
  }
  const std::vector<double> positions = file.attribute("POSITION");
  for (std::size_t v = 0; v < positions.size() / 3; ++v) positions_.push_back(vector_at(positions, v));
  for (const auto& animation : file.json()["animations"]) {
    if (animation["name"] != clip) continue;
    for (const auto& channel : animation["channels"]) {
      const auto& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
      times_ = file.values(sampler["input"]);
      tracks_.push_back(
          {channel["target"]["node"], channel["target"]["path"] == "rotation", file.values(sampler["output"])});
    }
  }
  if (tracks_.empty()) throw std::runtime_error("no such clip: " + clip);
}

std::size_t Playback::joint(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) throw std::runtime_error("no such joint: " + name);
  return static_cast<std::size_t>(found - names_.begin());
}

std::vector<PosedJoint> Playback::pose(double time) const {
  const auto after = std::upper_bound(times_.begin() + 1, times_.end() - 1, time);
  const auto next = static_cast<std::size_t>(after - times_.begin());
  const double part = std::clamp((time - times_[next - 1]) / (times_[next] - times_[next - 1]), 0.0, 1.0);
  std::vector<glm::dvec3> offsets = offsets_;
  std::vector<PosedJoint> posed(names_.size(), {{}, {}, glm::dquat(1, 0, 0, 0)});
  for (const Track& track : tracks_) {
    if (track.rotation) {
      posed[track.node].local = glm::normalize(glm::slerp(glm::normalize(quaternion_at(track.keys, next - 1)),
                                                          glm::normalize(quaternion_at(track.keys, next)), part));
    } else {
      offsets[track.node] = glm::mix(vector_at(track.keys, next - 1), vector_at(track.keys, next), part);
    }
  }
  posed[0].position = offsets[0];
  posed[0].rotation = posed[0].local;
  for (std::size_t j = 1; j < posed.size(); ++j) {
    const PosedJoint& parent = posed[parents_[j]];
    posed[j].position = parent.position + parent.rotation * offsets[j];
    posed[j].rotation = parent.rotation * posed[j].local;
  }
  return posed;
}

std::vector<glm::dvec3> Playback::skin(double time) const {
  const std::vector<PosedJoint> joints = pose(time);
  std::vector<glm::dvec3> surface(positions_.size(), glm::dvec3(0));
  for (std::size_t v = 0; v < surface.size(); ++v) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto j = static_cast<std::size_t>(joints_[4 * v + i]);
      surface[v] += weights_[4 * v + i] * (joints[j].position + joints[j].rotation * (positions_[v] - places_[j]));
    }
  }
  return surface;
}

}  // namespace throng::test
