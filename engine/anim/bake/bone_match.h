#pragma once

#include <vector>

#include "engine/anim/asset/skeleton.h"
#include "engine/base/result.h"

namespace throng::anim {

/// Returns for each bone of `other` its index in `skeleton`, if both are the same skeleton, in one order or in two: the
/// same bones by name, with the same parents and the same bind pose, because streams are relative to it. Errors: one
/// sentence with both names and the first bone that differs.
Result<std::vector<int>> match_bones(const Skeleton& skeleton, const Skeleton& other);

}  // namespace throng::anim
