#include "engine/anim/kernel/lanes/copy_blocks.h"

#include <algorithm>

#include "engine/anim/kernel/lanes/job_checks.h"

namespace throng::anim {

bool is_valid(const CopyBlocksJob& job) {
  if (job.blocks.empty()) return true;
  const auto is_lines = [](std::size_t bytes) { return bytes % job_alignment == 0; };
  const bool in_a_row = job.blocks.size() == 1 || (is_lines(job.stride) && job.stride >= job.size);
  return in_a_row && is_aligned(job.local) && is_lines(job.offset) && job.size > 0 && is_lines(job.size) &&
         std::ranges::all_of(job.blocks, [](const std::byte* block) { return is_aligned(block); });
}

}  // namespace throng::anim
