#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace throng::anim {

/// Numbers names in the order in which they come, each once. A file may have tens of thousands.
class NameNumbers {
 public:
  /// Goes on with `names`, whose indices are the numbers, and which take the new ones.
  explicit NameNumbers(std::vector<std::string>& names) : names_(names) {
    for (std::size_t i = 0; i < names.size(); ++i) numbers_.try_emplace(names[i], static_cast<std::uint32_t>(i));
  }

  std::uint32_t of(const std::string& name) {
    const auto [known, is_new] = numbers_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
    if (is_new) names_.push_back(name);
    return known->second;
  }

 private:
  std::vector<std::string>& names_;
  std::unordered_map<std::string, std::uint32_t> numbers_;
};

}  // namespace throng::anim
