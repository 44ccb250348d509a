#include "engine/anim/kernel/kernels.h"

#include "engine/anim/kernel/targets.h"
// After targets.h, which says what Highway compiles for.
#include <hwy/targets.h>

namespace throng::anim {
namespace {

Kernels kernels_of(std::int64_t target) {
  hwy::ChosenTarget chosen;
  chosen.Update(target);
  Kernels kernels{};
  set_pose_kernels(chosen.GetIndex(), kernels);
  set_limb_kernels(chosen.GetIndex(), kernels);
  set_palette_kernels(chosen.GetIndex(), kernels);
  return kernels;
}

/// Returns one bit for each target that was compiled and that this machine can run. A lower bit is a better one.
std::int64_t runnable_targets() {
#if defined(THRONG_PLAIN_NEON)
  return (hwy::SupportedTargets() | HWY_NEON) & HWY_TARGETS;  // Highway leaves NEON out where there is no AES
#else
  return hwy::SupportedTargets() & HWY_TARGETS;
#endif
}

std::vector<Kernels> find_runnable_kernels() {
  std::vector<Kernels> sets;
  for (std::int64_t left = runnable_targets(); left != 0; left &= left - 1) sets.push_back(kernels_of(left & -left));
  return sets;
}

}  // namespace

std::span<const Kernels> runnable_kernels() {
  static const std::vector<Kernels> sets = find_runnable_kernels();
  return sets;
}

std::vector<std::string> compiled_targets() {
  std::vector<std::string> names;
  for (std::int64_t left = HWY_TARGETS; left != 0; left &= left - 1) names.emplace_back(hwy::TargetName(left & -left));
  return names;
}

const Kernels& scalar_kernels() { return runnable_kernels().back(); }

}  // namespace throng::anim
