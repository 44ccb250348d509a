#pragma once

#include <span>
#include <string>
#include <vector>

#include "throng/character.h"

#include "engine/anim/asset/skeleton.h"

namespace throng::detail {

/// Gives bones the parts of the body that a host chose for them, in every skeleton of a file that has such bones.
class ChosenRig {
 public:
  explicit ChosenRig(std::span<const BoneRole> roles) : roles_(roles), is_found_(roles.size(), false) {}

  bool empty() const { return roles_.empty(); }
  void give_to(anim::Skeleton& skeleton);
  /// Returns whether each role and bone was found. The error names the first that was not.
  Status outcome(const std::string& file) const;

 private:
  std::span<const BoneRole> roles_;
  std::vector<bool> is_found_;  // [role]
};

}  // namespace throng::detail
