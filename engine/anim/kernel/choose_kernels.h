#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace throng::anim {

struct Kernels;

/// Returns the kernels of a target that this build has and this machine runs, or null if it is none of those. `name` is
/// Highway's name in any case ("avx2"), or "avx512", which is the best of AVX3, AVX3_DL and their like.
const Kernels* find_kernels(std::string_view name);

/// Returns the names of all targets that find_kernels() finds, the best first.
std::vector<std::string> runnable_targets();

/// Makes best_kernels() return these from now on, so that all that poses, bakes and copies runs on one target. They
/// must be among runnable_kernels(). Call it before anything is baked or posed: a caller that has asked for kernels
/// before may keep them. A crowd whose SystemOptions name kernels has its own.
void choose_kernels(const Kernels& kernels);

}  // namespace throng::anim
