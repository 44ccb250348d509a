#include "engine/anim/kernel/kernels.h"

#include <vector>

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

std::vector<Kernels> find_runnable_kernels() {
  std::vector<Kernels> sets;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) sets.push_back(kernels_of(target));
  return sets;
}

}  // namespace

std::span<const Kernels> runnable_kernels() {
  static const std::vector<Kernels> sets = find_runnable_kernels();
  return sets;
}

const Kernels& best_kernels() { return runnable_kernels().front(); }

const Kernels& scalar_kernels() { return runnable_kernels().back(); }

}  // namespace throng::anim
