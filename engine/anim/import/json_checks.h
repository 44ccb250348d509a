#pragma once

#include <nlohmann/json_fwd.hpp>

namespace throng::import {

/// Checks that everything import reads has the type, the length and, for an index, the range that glTF demands, and
/// that import knows every required extension. Throws Refusal with the object's name.
void check_json(const nlohmann::json& document);

}  // namespace throng::import
