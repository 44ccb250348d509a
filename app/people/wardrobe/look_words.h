#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/render/agent_look.h"

// These functions name patterns and fabrics as rules do.

namespace throng::app {

std::optional<render::Pattern> pattern_named(std::string_view name);
std::optional<render::Fabric> fabric_named(std::string_view name);
std::string pattern_name(render::Pattern pattern);
std::string fabric_name(render::Fabric fabric);
std::string known_patterns();  ///< "plain, stripes_across, ... and herringbone"
std::string known_fabrics();

}  // namespace throng::app
