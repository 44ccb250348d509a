#pragma once

#include <cstddef>
#include <functional>

namespace throng::anim {

/// Calls work(0) to work(count - 1), each once, on as many threads as there are cores to run on, or fewer where
/// the system has no more. Returns when all are done.
void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace throng::anim
