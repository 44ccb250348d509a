#include "app/overlay/preset_name.h"

#include <algorithm>
#include <cctype>

namespace throng::app {
namespace {

bool may_stand_in_a_name(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == ' ' || letter == '-' || letter == '_';
}

}  // namespace

bool can_name_a_preset(const std::string& name) {
  return !name.empty() && name.front() != ' ' && name.back() != ' ' && std::ranges::all_of(name, may_stand_in_a_name);
}

}  // namespace throng::app
