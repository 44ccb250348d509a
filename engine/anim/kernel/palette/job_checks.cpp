#include "engine/anim/kernel/lanes/job_checks.h"

#include <algorithm>
#include <span>

#include "engine/anim/kernel/palette/model_joints.h"
#include "engine/anim/kernel/palette/model_palette.h"
#include "engine/anim/kernel/palette/surface_error.h"
#include "engine/anim/kernel/palette/write_lines.h"

namespace throng::anim {
namespace {

constexpr std::size_t entry_alignment = 16;
constexpr std::size_t floats_of_a_line = 16;

bool is_width(int width) { return width == 1 || width == 2 || width == 4 || width == 8 || width == widest_strip; }

bool are_palettes(const ModelPaletteJob& job) {
  if (job.palettes == nullptr) return false;
  return std::ranges::all_of(std::span(job.palettes, static_cast<std::size_t>(job.characters)),
                             [](PaletteDestination to) { return is_aligned(to.memory(), entry_alignment); });
}

bool are_lists(float* const* to, int width) {
  return to != nullptr && std::ranges::all_of(std::span(to, static_cast<std::size_t>(width)),
                                              [](float* list) { return is_aligned(list, entry_alignment); });
}

bool is_policy(StorePolicy stores) { return stores <= StorePolicy::streaming; }

}  // namespace

bool is_valid(const ModelPaletteJob& job) {
  if (job.hierarchy == nullptr || job.packet < 0) return false;
  if (job.bone_count < 0 || job.bone_count > job.hierarchy->bone_count) return false;
  if (!is_width(job.width) || job.characters < 1 || job.characters > job.width) return false;
  if (!is_aligned(job.local) || !is_aligned(job.carry)) return false;
  if (!is_aligned(job.branch_slots) && job.hierarchy->slot_count > 0) return false;
  const bool written = job.format == PaletteFormat::matrices ||
                       (job.format == PaletteFormat::packed && job.hierarchy->rigid && job.hierarchy->packs());
  const bool lists =
      job.joints == nullptr || (job.format == PaletteFormat::matrices && are_lists(job.joints_to, job.width));
  return written && lists && job.displaced <= all_quads && is_policy(job.stores) && are_palettes(job);
}

bool is_valid(const ModelJointsJob& job) {
  if (job.program == nullptr || job.packet < 0 || !is_width(job.width)) return false;
  if (static_cast<std::size_t>(job.packet) + 1 >= job.program->first_step.size()) return false;
  if (!is_aligned(job.local) || !is_aligned(job.carry)) return false;
  if (!is_aligned(job.branch_slots) && job.program->hierarchy.slot_count > 0) return false;
  return job.displaced <= all_quads && are_lists(job.to, job.width);
}

bool is_valid(const WriteLinesJob& job) {
  return (job.lines.empty() || is_aligned(job.lines.data())) && job.lines.size() % floats_of_a_line == 0 &&
         is_policy(job.stores);
}

bool is_valid(const ShownPaletteJob& job) {
  const auto is_unpacked = [&](std::size_t entry) { return job.packing.empty() || entry < job.packing.size(); };
  return is_aligned(job.from.memory(), entry_alignment) && is_aligned(job.to.memory(), entry_alignment) &&
         is_share(job.blend) && job.shown.size() == job.kept_entries.size() &&
         std::ranges::all_of(job.kept_entries, is_unpacked);
}

}  // namespace throng::anim
