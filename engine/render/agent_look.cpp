#include "throng/render/agent_look.h"

#include <atomic>

namespace throng::render {

std::uint64_t new_looks_number() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace throng::render
