#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace throng::import {

/// Mends faults that glTF forbids but that have one meaning, in a document that passed check_json, and adds a sentence
/// for each to `repairs`: rotations of other than unit length are normalised, last rows of matrices become 0, 0, 0, 1,
/// and a scene that names a child takes it with all below it.
void repair_json(nlohmann::json& document, std::vector<std::string>& repairs);

}  // namespace throng::import
