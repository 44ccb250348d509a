#include "engine/anim/kernel/choose_kernels.h"

#include <algorithm>
#include <atomic>

#include "engine/anim/kernel/kernels.h"

namespace throng::anim {
namespace {

/// Null until choose_kernels() is called.
std::atomic<const Kernels*> chosen = nullptr;

char upper(char letter) { return letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter; }

bool is_named(const Kernels& kernels, std::string_view name) {
  const std::string_view target = kernels.target;
  if (name == "AVX512") return target.starts_with("AVX3");
  return target == name;
}

}  // namespace

const Kernels* find_kernels(std::string_view name) {
  std::string upper_name(name);
  std::ranges::transform(upper_name, upper_name.begin(), upper);
  const auto all = runnable_kernels();
  const auto found = std::ranges::find_if(all, [&](const Kernels& each) { return is_named(each, upper_name); });
  return found == all.end() ? nullptr : &*found;
}

std::vector<std::string> runnable_targets() {
  std::vector<std::string> names;
  for (const Kernels& kernels : runnable_kernels()) names.emplace_back(kernels.target);
  return names;
}

void choose_kernels(const Kernels& kernels) { chosen.store(&kernels, std::memory_order_release); }

const Kernels& best_kernels() {
  const Kernels* const kernels = chosen.load(std::memory_order_acquire);
  return kernels == nullptr ? runnable_kernels().front() : *kernels;
}

}  // namespace throng::anim
