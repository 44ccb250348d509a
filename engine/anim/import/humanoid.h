#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "engine/anim/asset/body_role.h"

namespace throng::import {

/// Holds the map of bones and the facing that a VRM extension states.
struct Humanoid {
  std::vector<std::optional<anim::BodyRole>> roles;  ///< by node; empty where the file says nothing
  bool faces_backwards = false;                      ///< VRM 0.x looks along -Z, VRM 1.0 along +Z as glTF demands
};

/// Reads the map of bones of VRM 1.0 (`VRMC_vrm`) or 0.x (`VRM`) from a checked document. These extensions are
/// optional, so entries that are malformed are left out, and a sentence in `repairs` says so. Eyes, jaw and fingers
/// are passed over.
Humanoid read_humanoid(const nlohmann::json& document, std::vector<std::string>& repairs);

}  // namespace throng::import
