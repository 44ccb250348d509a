#include "engine/anim/import/humanoid.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <nlohmann/json.hpp>

namespace throng::import {

namespace {

using nlohmann::json;

/// Returns the member of an object, or null where there is none or `object` is none.
const json& member(const json& object, const char* key) {
  static const json nothing;
  if (!object.is_object()) return nothing;
  const auto found = object.find(key);
  return found == object.end() ? nothing : *found;
}

class HumanoidReader {
 public:
  HumanoidReader(std::size_t nodes, bool faces_backwards) {
    humanoid_.roles.resize(nodes);
    humanoid_.faces_backwards = faces_backwards;
  }

  void take(const std::string& part, const json& node) {
    const auto role = anim::body_role_named(part);
    if (!role) return;
    const bool is_node = node.is_number_unsigned() || (node.is_number_integer() && node.get<std::int64_t>() >= 0);
    const bool is_free = is_node && node.get<std::uint64_t>() < humanoid_.roles.size() &&
                         !humanoid_.roles[node.get<std::size_t>()] && std::ranges::count(taken_, *role) == 0;
    if (!is_free) {
      left_out_ += (left_out_.empty() ? "" : ", ") + part;
      return;
    }
    humanoid_.roles[node.get<std::size_t>()] = role;
    taken_.push_back(*role);
  }

  Humanoid finish(const std::string& extension, std::vector<std::string>& repairs) {
    if (!left_out_.empty()) {
      repairs.push_back(extension + ": its map of bones has no node, or one that is taken, for " + left_out_ +
                        "; left out");
    }
    if (taken_.empty()) humanoid_.roles.clear();
    return std::move(humanoid_);
  }

 private:
  Humanoid humanoid_;
  std::vector<anim::BodyRole> taken_;
  std::string left_out_;
};

}  // namespace

Humanoid read_humanoid(const json& document, std::vector<std::string>& repairs) {
  const json& extensions = member(document, "extensions");
  const json& vrm1 = member(extensions, "VRMC_vrm");
  const json& vrm0 = member(extensions, "VRM");
  if (vrm1.is_null() && vrm0.is_null()) return {};
  HumanoidReader reader(member(document, "nodes").size(), vrm1.is_null());
  const json& bones = member(member(vrm1.is_null() ? vrm0 : vrm1, "humanoid"), "humanBones");
  for (const auto& [key, bone] : bones.items()) {
    const json part = vrm1.is_null() ? member(bone, "bone") : json(key);
    if (part.is_string()) reader.take(part.get<std::string>(), member(bone, "node"));
  }
  return reader.finish(vrm1.is_null() ? "VRM" : "VRMC_vrm", repairs);
}

}  // namespace throng::import
