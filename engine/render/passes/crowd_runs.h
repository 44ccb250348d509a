#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "throng/render/crowd_draw.h"

namespace throng::render {

/// Calls `do_run` with all batches of each page and character.
void for_each_run(std::span<const CrowdBatch> batches, const auto& do_run) {
  while (!batches.empty()) {
    const CrowdBatch& first = batches.front();
    const auto other = std::ranges::find_if(batches, [&](const CrowdBatch& batch) {
      return batch.page != first.page || batch.character != first.character;
    });
    const auto count = static_cast<std::size_t>(other - batches.begin());
    do_run(batches.first(count));
    batches = batches.subspan(count);
  }
}

}  // namespace throng::render
