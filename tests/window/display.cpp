#include "tests/window/display.h"

namespace throng::app {
namespace {

std::string screen_of(glm::ivec2 size) { return std::to_string(size.x) + "x" + std::to_string(size.y) + "x24"; }

}  // namespace

// Xvfb looks for a free number by itself and writes it where -displayfd says: to its standard output.
Display::Display(const std::filesystem::path& folder, glm::ivec2 size, Deadline deadline)
    : folder_(folder), server_({"Xvfb", "-displayfd", "1", "-screen", "0", screen_of(size), "-nolisten", "tcp"}, {}) {
  const auto number = server_.started() ? server_.read_line(deadline) : std::nullopt;
  if (number) name_ = ":" + *number;
}

std::vector<std::string> Display::environment() const {
  return {"DISPLAY=" + name_, "WAYLAND_DISPLAY=", "LIBGL_ALWAYS_SOFTWARE=1",
          "XDG_CONFIG_HOME=" + (folder_ / "config").string()};
}

bool Display::xdotool(const std::vector<std::string>& words, Deadline deadline) const {
  std::vector<std::string> command = {"xdotool"};
  command.insert(command.end(), words.begin(), words.end());
  ChildProcess tool(command, environment());
  return tool.started() && tool.exit_status(deadline) == 0;
}

}  // namespace throng::app
