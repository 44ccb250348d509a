#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

namespace throng::test {

/// Takes a binary glTF file apart without the project's importer, as far as the built-in character needs it.
class CharacterFile {
 public:
  explicit CharacterFile(std::vector<std::byte> bytes);
  static std::vector<std::byte> read(const std::filesystem::path& path);
  static CharacterFile committed();

  [[nodiscard]] const nlohmann::json& json() const { return json_; }
  /// Returns the one primitive of the one mesh.
  [[nodiscard]] const nlohmann::json& primitive() const { return json_["meshes"][0]["primitives"][0]; }
  /// Returns all numbers of an accessor as stored, components in a row.
  [[nodiscard]] std::vector<double> values(std::size_t accessor) const;
  [[nodiscard]] std::vector<double> attribute(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> joint_names() const;

 private:
  std::vector<std::byte> bytes_;
  nlohmann::json json_;
  std::size_t buffer_start_ = 0;
};

struct PosedJoint {
  glm::dvec3 position;
  glm::dquat rotation;
  glm::dquat local;
};

/// Plays one clip of the character in double precision, as the glTF 2.0 specification says (appendix C).
class Playback {
 public:
  Playback(const CharacterFile& file, const std::string& clip);

  [[nodiscard]] double duration() const { return times_.back(); }
  [[nodiscard]] std::size_t key_count() const { return times_.size(); }
  [[nodiscard]] double key_time(std::size_t key) const { return times_[key]; }
  [[nodiscard]] glm::dvec3 rest(std::size_t joint) const { return places_[joint]; }
  /// Returns the joints in node order. Nodes 0 to 61 of the character are its joints.
  [[nodiscard]] std::vector<PosedJoint> pose(double time) const;
  [[nodiscard]] std::vector<glm::dvec3> skin(double time) const;
  [[nodiscard]] std::size_t joint(const std::string& name) const;

 private:
  struct Track {
    std::size_t node;
    bool rotation;
    std::vector<double> keys;
  };
  std::vector<std::string> names_;
  std::vector<std::size_t> parents_;
  std::vector<glm::dvec3> offsets_, places_, positions_;
  std::vector<double> joints_, weights_, times_;
  std::vector<Track> tracks_;
};

std::vector<std::string> clip_names(const CharacterFile& file);

}  // namespace throng::test
