#include <string>

#include <fcntl.h>
#include <unistd.h>

#include "tests/window/window_driver.h"

namespace throng::app::live_window_test {
namespace {

using Json = nlohmann::json;

/// A window whose standard input is a pipe of ours.
class LiveWindow : public WindowDriver {
 protected:
  LiveWindow() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return;
    before_ = dup(STDIN_FILENO);
    dup2(ends[0], STDIN_FILENO);
    close(ends[0]);
    end_ = ends[1];
    send("id,time,x,y\nann,0,0,0\n");
  }
  ~LiveWindow() override {
    end();
    dup2(before_, STDIN_FILENO);
    close(before_);
  }
  LiveWindow(const LiveWindow&) = delete;
  LiveWindow& operator=(const LiveWindow&) = delete;

  std::vector<std::string> options() const override {
    return {"--trajectories", "-", "--agents", "20", "--size", "1000x700"};
  }
  void send(const std::string& rows) const {
    ASSERT_EQ(write(end_, rows.data(), rows.size()), static_cast<ssize_t>(rows.size()));
  }
  void end() {
    if (end_ >= 0) close(end_);
    end_ = -1;
  }
  Json wait_for_people(int people) {
    return wait_for(std::to_string(people) + " people",
                    [people](const Json& now) { return now["report"]["drawn"] == people; });
  }

 private:
  int before_ = -1, end_ = -1;
};

TEST_F(LiveWindow, ShowsPeopleAsTheirRowsComeAndKeepsThemAtTheEnd) {
  wait_for_people(1);
  std::string rows;
  for (int row = 1; row < 30; ++row) {
    const std::string time = "," + std::to_string(0.1 * row) + ",";
    rows += "ann" + time + std::to_string(0.1 * row) + ",0\nbob" + time + std::to_string(0.1 * row) + ",2\n";
  }
  send(rows);
  wait_for_people(2);
  end();
  wait_for("the end", [](const Json& now) {
    return now["report"]["notice"].get<std::string>().find("The input has ended") != std::string::npos;
  });
  EXPECT_EQ(next_map(5)["report"]["drawn"], 2);
}

}  // namespace
}  // namespace throng::app::live_window_test
