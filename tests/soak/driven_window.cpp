#include "tests/soak/driven_window.h"

#include <chrono>
#include <cmath>
#include <fstream>
#include <thread>

#include "tests/window/file_drop.h"

namespace throng::soak {
namespace {

using app::ChildProcess;
using std::chrono::steady_clock;

/// Late enough for a machine that does much else.
app::Deadline deadline() { return steady_clock::now() + std::chrono::seconds(90); }

std::string pixels(double place) { return std::to_string(std::lround(place)); }

}  // namespace

DrivenWindow::DrivenWindow(const std::vector<std::string>& words, const std::filesystem::path& folder)
    : folder_(folder), display_(folder, app::usual_screen, deadline()) {
  std::vector<std::string> command = {THRONG_PROGRAM, "--ui-map", (folder_ / "ui.json").string()};
  command.insert(command.end(), words.begin(), words.end());
  program_ = std::make_unique<ChildProcess>(command, display_.environment(), folder_.string());
}

bool DrivenWindow::is_there() {
  return display_.is_there() && program_->started() &&
         wait_for([](const Json& map) { return !map["widgets"].empty(); }).has_value();
}

std::optional<int> DrivenWindow::end() {
  xdotool({"key", "ctrl+q"});
  const auto asks = wait_for([](const Json& map) { return map["widgets"].contains("unsaved:leave"); });
  if (asks) xdotool({"key", "l"});  // else it has ended
  return program_->exit_status(deadline());
}

std::optional<DrivenWindow::Json> DrivenWindow::wait_for(const std::function<bool(const Json&)>& holds) {
  for (const app::Deadline end = deadline(); steady_clock::now() < end;) {
    // A line that it printed makes room in its pipe.
    while (program_->read_line(steady_clock::now())) continue;
    if (program_->exit_status(steady_clock::now())) return {};
    std::ifstream stream(folder_ / "ui.json");
    const Json map = Json::parse(stream, nullptr, false);
    if (map.is_object() && holds(map)) return std::optional<Json>(std::in_place, map);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return {};
}

std::optional<DrivenWindow::Json> DrivenWindow::next_map(int frames) {
  const auto now = wait_for([](const Json&) { return true; });
  if (!now) return {};
  const int frame = (*now)["frame"];
  return wait_for([&](const Json& map) { return map["frame"] >= frame + frames; });
}

bool DrivenWindow::xdotool(const std::vector<std::string>& words) { return display_.xdotool(words, deadline()); }

bool DrivenWindow::drag(const Json& widget, double share) {
  const double x = widget["x"], y = widget["y"], width = widget["w"], height = widget["h"];
  const std::string row = pixels(std::floor(y + height / 2));
  if (!xdotool({"mousemove", pixels(std::floor(x + width / 2)), row, "mousedown", "1"}) || !next_map()) return false;
  if (share != 0.5 && (!xdotool({"mousemove", pixels(std::floor(x + width * share)), row}) || !next_map()))
    return false;
  return xdotool({"mouseup", "1"}) && next_map().has_value();
}

bool DrivenWindow::drop(const std::string& file) { return app::drop_file(display_.name(), file, deadline()); }

}  // namespace throng::soak
