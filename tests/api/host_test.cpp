// What a host does in the library's place.

#include <atomic>
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/api/api_crowd.h"

namespace throng::host_test {
namespace {

using api_test::ApiCrowd;

struct Account {
  std::size_t given = 0;
  std::size_t taken = 0;
};

TEST(ApiHost, GivesTheMemoryOfBlocksAndTakesItBack) {
  Account account;
  const MemoryHooks hooks{.allocate =
                              [](std::size_t bytes, std::size_t alignment, void* context) {
                                static_cast<Account*>(context)->given += bytes;
                                return std::aligned_alloc(alignment, bytes);
                              },
                          .release =
                              [](void* memory, std::size_t bytes, std::size_t, void* context) {
                                static_cast<Account*>(context)->taken += bytes;
                                std::free(memory);
                              },
                          .context = &account};
  api_test::mannequin();  // it stays for the tests that come after
  set_memory_hooks(hooks);
  {
    ApiCrowd crowd(1000);
    set_memory_hooks({});
    EXPECT_GT(account.given, std::size_t{100'000});
  }
  EXPECT_EQ(account.taken, account.given);
}

TEST(ApiHost, IsToldOfEachThread) {
  static std::atomic<int> told;
  told = 0;
  set_thread_hook([](int pu) { told += pu; });
  {
    ApiCrowd crowd(1, {.pus = 4});
    crowd.agent(0).play({.clip = {0}});
    crowd.step();
  }
  set_thread_hook(nullptr);
  EXPECT_EQ(told, 1 + 2 + 3);
}

}  // namespace
}  // namespace throng::host_test
