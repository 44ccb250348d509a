#include "app/people/wardrobe/look_words.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

// The names stand in the order of the enumerators.
constexpr std::array<const char*, 13> pattern_names{"plain",   "stripes_across", "stripes_along", "checks", "tartan",
                                                    "dots",    "denim",          "print",         "trim",   "blocks",
                                                    "flowers", "camouflage",     "herringbone"};
constexpr std::array<const char*, 8> fabric_names{"cotton",  "denim", "wool", "satin",
                                                  "leather", "nylon", "skin", "plastic"};
static_assert(pattern_names.size() == static_cast<std::size_t>(render::Pattern::herringbone) + 1);
static_assert(fabric_names.size() == static_cast<std::size_t>(render::Fabric::plastic) + 1);

template <typename Value, std::size_t N>
std::optional<Value> named_value(const std::array<const char*, N>& names, std::string_view name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return {};
  return static_cast<Value>(found - names.begin());
}

}  // namespace

std::optional<render::Pattern> pattern_named(std::string_view name) {
  return named_value<render::Pattern>(pattern_names, name);
}

std::optional<render::Fabric> fabric_named(std::string_view name) {
  return named_value<render::Fabric>(fabric_names, name);
}

std::string pattern_name(render::Pattern pattern) { return pattern_names.at(static_cast<std::size_t>(pattern)); }
std::string fabric_name(render::Fabric fabric) { return fabric_names.at(static_cast<std::size_t>(fabric)); }
std::string known_patterns() { return joined(pattern_names, ", ", " and "); }
std::string known_fabrics() { return joined(fabric_names, ", ", " and "); }

}  // namespace throng::app
