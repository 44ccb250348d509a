#include "engine/anim/agent/system_options.h"

#include <bit>
#include <string>

namespace throng::anim {
namespace {

template <typename Enum>
bool is_one_of(Enum value, Enum last) {
  return static_cast<unsigned>(value) <= static_cast<unsigned>(last);
}

bool are_words(const SystemOptions& options) {
  return is_one_of(options.schedule, Schedule::levels) &&
         is_one_of(options.double_buffering, DoubleBuffering::interleaved) &&
         is_one_of(options.stream, StreamKind::keyframe) && is_one_of(options.trace, Tracing::every_task) &&
         is_one_of(options.palettes, PaletteFormat::packed) &&
         (!options.stores || is_one_of(*options.stores, StorePolicy::streaming));
}

}  // namespace

Status check(const SystemOptions& options) {
  if (options.pus < 1 || options.pus > max_pus) {
    return Error{std::to_string(options.pus) + " PUs: give 1 to " + std::to_string(max_pus)};
  }
  if (options.local_store_bytes > most_local_store_bytes) {
    return Error{"a local store of " + std::to_string(options.local_store_bytes) + " bytes: give at most " +
                 std::to_string(most_local_store_bytes) + ", or 0 to have it fitted"};
  }
  if (options.tile < 0 || options.tile > 16 ||
      (options.tile > 0 && !std::has_single_bit(static_cast<unsigned>(options.tile)))) {
    return Error{"a tile of " + std::to_string(options.tile) +
                 " characters: give 1, 2, 4, 8 or 16, or 0 to have it fitted"};
  }
  if (!are_words(options)) return Error{"an option has a value that its type does not: give one of the names"};
  return Done{};
}

}  // namespace throng::anim
