#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "engine/anim/import/buffer_views.h"

namespace throng::import {

/// Decodes every primitive that KHR_draco_mesh_compression holds, in a document that passed check_json. Each of its
/// accessors then has a view of its own, so that its readers need not know. Before it decodes, it checks that the
/// bytes can hold what they say. `repairs` names accessors of another count. Charges `memory`. Throws Refusal with
/// the primitive's name.
void decode_draco_meshes(nlohmann::json& document, BufferViews& views, std::vector<std::string>& repairs,
                         MemoryAccount& memory);

}  // namespace throng::import
