#include "app/files/memory_check.h"

#include "engine/base/files/free_memory.h"
#include "engine/base/text/size_text.h"

namespace throng::app {

Status check_memory(const std::string& what, std::uint64_t needed, const std::string& remedy) {
  if (needed == 0) return Done{};  // a dragged value is checked in every frame
  const std::uint64_t left = free_memory();
  if (needed <= left) return Done{};
  return Error{what + " need " + size_text(needed) + " of memory, but " + size_text(left) + " are left; " + remedy};
}

}  // namespace throng::app
