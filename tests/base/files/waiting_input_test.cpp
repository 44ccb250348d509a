#include "engine/base/files/waiting_input.h"

#include <array>
#include <string_view>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

namespace throng::waiting_input_test {
namespace {

/// A pipe that is read through a WaitingInput.
class WaitingPipe : public testing::Test {
 protected:
  WaitingPipe() { EXPECT_EQ(pipe(ends_.data()), 0); }
  ~WaitingPipe() override {
    for (const int end : ends_) close(end);
  }
  int reads() const { return ends_[0]; }
  int writes() const { return ends_[1]; }

 private:
  std::array<int, 2> ends_{-1, -1};
};

TEST_F(WaitingPipe, GivesWhatIsThereAndThenTheEnd) {
  WaitingInput input(reads());
  ASSERT_TRUE(input.open());
  ASSERT_EQ(write(writes(), "row\n", 4), 4);
  std::array<char, 16> bytes{};
  const auto read = input.read(bytes);
  ASSERT_TRUE(read && *read);
  EXPECT_EQ(std::string_view(bytes.data(), **read), "row\n");
  ASSERT_EQ(dup2(STDIN_FILENO, writes()), writes());  // closes the writer's end
  const auto end = input.read(bytes);
  ASSERT_TRUE(end && *end);
  EXPECT_EQ(**end, 0U);
}

TEST_F(WaitingPipe, EndsTheReadOfAnotherThreadOnceStopped) {
  WaitingInput input(reads());
  ASSERT_TRUE(input.open());
  std::thread reader([&] {
    std::array<char, 16> bytes{};
    const auto read = input.read(bytes);
    EXPECT_TRUE(read && !*read);
  });
  input.stop();
  reader.join();
  input.stop();
  std::array<char, 16> bytes{};
  const auto later = input.read(bytes);
  EXPECT_TRUE(later && !*later);
}

}  // namespace
}  // namespace throng::waiting_input_test
