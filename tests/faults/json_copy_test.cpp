#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "engine/base/json/json.h"

namespace {
long until_failure = -1;  // allocations that succeed before one that fails; -1: none fails
}

// This program alone takes its memory here.
void* operator new(std::size_t size) {
  if (until_failure >= 0 && until_failure-- == 0) throw std::bad_alloc();
  if (void* const block = std::malloc(size == 0 ? 1 : size)) return block;
  throw std::bad_alloc();
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t /*size*/) noexcept { std::free(block); }

namespace throng::json_copy_test {
namespace {

TEST(JsonWithoutMemory, IsAnExceptionAndNothingElse) {
  const Json inner =
      Json::array({Json{{"a key that is no short text", 1}, {"another one", "a text that is rather long"}}});
  for (long count = 0;; ++count) {
    until_failure = count;
    try {
      const Json outer = {{"a key that is no short text", inner}, {"nested", {{"first", inner}, {"second", inner}}}};
      until_failure = -1;
      EXPECT_EQ(outer["nested"]["second"], inner);
      EXPECT_GT(count, 20) << "each of them failed once";
      return;
    } catch (const std::bad_alloc&) {
      until_failure = -1;
    }
  }
}

}  // namespace
}  // namespace throng::json_copy_test
