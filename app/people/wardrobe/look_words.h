#pragma once

#include <array>
#include <cstddef>

#include "throng/render/agent_look.h"

namespace throng::app {

// Rules call patterns and fabrics so. The names stand in the order of the enumerators.
inline constexpr std::array<const char*, 13> pattern_names{
    "plain", "stripes_across", "stripes_along", "checks",  "tartan",     "dots",       "denim",
    "print", "trim",           "blocks",        "flowers", "camouflage", "herringbone"};
inline constexpr std::array<const char*, 8> fabric_names{"cotton",  "denim", "wool", "satin",
                                                         "leather", "nylon", "skin", "plastic"};
static_assert(pattern_names.size() == static_cast<std::size_t>(render::Pattern::herringbone) + 1);
static_assert(fabric_names.size() == static_cast<std::size_t>(render::Fabric::plastic) + 1);

}  // namespace throng::app
