#include "tests/window/window_driver.h"

#include <cmath>
#include <fstream>
#include <sstream>
#include <thread>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <unistd.h>

#include "app/show/camera/fly_camera.h"
#include "tests/window/file_drop.h"

namespace throng::app {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

std::string whole_pixels(double place) { return std::to_string(std::lround(std::floor(place))); }

std::string contents(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

}  // namespace

void WindowDriver::SetUp() {
  ASSERT_NO_FATAL_FAILURE(start_display());
  ASSERT_NO_FATAL_FAILURE(start_program(options()));
  ASSERT_NO_FATAL_FAILURE(wait_for("a first ui map", [](const Json& map) { return !map["widgets"].empty(); }));
}

void WindowDriver::start_display() {
  display_ = std::make_unique<Display>(folder_.path(), screen(), soon());
  ASSERT_TRUE(display_->is_there()) << "Xvfb does not start: install xvfb";
}

void WindowDriver::start_program(const std::vector<std::string>& options) {
  const std::filesystem::path map = folder_.path() / "ui.json";
  program_.reset();
  std::filesystem::remove(map);
  std::vector<std::string> words{THRONG_PROGRAM, "--ui-map", map.string()};
  words.insert(words.end(), options.begin(), options.end());
  program_ = std::make_unique<ChildProcess>(words, display_->environment(), folder_.path());
  ASSERT_TRUE(program_->started());
  while (const auto line = program_->read_line(soon())) {
    if (*line == "READY") return;
  }
  FAIL() << "the program did not say READY";
}

WindowDriver::Json WindowDriver::wait_for(const std::string& what, const std::function<bool(const Json&)>& holds) {
  Json map;
  for (const Deadline deadline = soon(); steady_clock::now() < deadline;) {
    map = Json::parse(contents(folder_.path() / "ui.json"), nullptr, false);
    if (map.is_object() && holds(map)) return map;
    std::this_thread::sleep_for(milliseconds(5));
  }
  [&] { FAIL() << "waited in vain for " << what << "; the last state is " << map["tuning"] << map["report"]; }();
  return map;
}

WindowDriver::Json WindowDriver::next_map(int frames) {
  const int now = wait_for("a map", [](const Json&) { return true; })["frame"];
  return wait_for("another frame", [&](const Json& map) { return map["frame"] >= now + frames; });
}

void WindowDriver::xdotool(const std::vector<std::string>& words) {
  EXPECT_TRUE(display_->xdotool(words, soon())) << words.front() << ": is xdotool installed?";
}

void WindowDriver::point_at(double x, double y) { xdotool({"mousemove", whole_pixels(x), whole_pixels(y)}); }

void WindowDriver::button(int number, bool down) {
  xdotool({down ? "mousedown" : "mouseup", std::to_string(number)});
  next_map();
}

void WindowDriver::click(const std::string& widget) { drag(widget, 0.5); }

void WindowDriver::drag(const std::string& widget, double share) {
  const Json map = wait_for("the widget " + widget, [&](const Json& now) { return now["widgets"].contains(widget); });
  const Json place = map["widgets"][widget];
  const double x = place["x"], y = place["y"], width = place["w"], height = place["h"];
  point_at(x + width / 2, y + height / 2);
  button(1, true);
  if (share != 0.5) {
    point_at(x + width * share, y + height / 2);
    next_map();
  }
  button(1, false);
}

void WindowDriver::drag_to(const std::string& widget, const std::string& other) {
  const Json widgets = wait_for("both widgets", [&](const Json& now) {
    return now["widgets"].contains(widget) && now["widgets"].contains(other);
  })["widgets"];
  const auto point_at_middle = [&](const Json& place) {
    point_at(place["x"].get<double>() + place["w"].get<double>() / 2,
             place["y"].get<double>() + place["h"].get<double>() / 2);
    next_map();
  };
  point_at_middle(widgets[widget]);
  button(1, true);
  point_at_middle(widgets[other]);
  button(1, false);
}

void WindowDriver::scroll_down_at(double x, double y, int steps) {
  point_at(x, y);
  next_map();
  xdotool({"click", "--repeat", std::to_string(steps), "5"});
  next_map();
}

WindowDriver::Json WindowDriver::wait_for_message(const std::string& words) {
  return wait_for(words, [&](const Json& map) {
    return map["report"]["message"].get<std::string>().find(words) != std::string::npos;
  });
}

std::string WindowDriver::folder_of_models(const std::vector<std::string>& names) {
  const std::filesystem::path models = folder() / "models";
  std::filesystem::create_directories(models);
  for (const std::string& name : names) {
    std::filesystem::copy_file(THRONG_SOURCE_DIR "/tests/data/features/plain.glb", models / name);
  }
  return models.string();
}

void WindowDriver::open_tab(const std::string& name) {
  click("tab:" + name);
  wait_for("tab " + name, [&](const Json& map) { return map["tab"] == name; });
}

void WindowDriver::click_in_tab(const std::string& widget) {
  bring_into_sight(widget);
  click(widget);
}

void WindowDriver::type_in_tab(const std::string& widget, const std::string& text) {
  bring_into_sight(widget);
  type_into(widget, text);
}

void WindowDriver::bring_into_sight(const std::string& widget) {
  constexpr int to_the_top = 60, most_turns = 60;
  Json map = next_map();
  const Json size = map["size"], tab = map["widgets"]["tab:Crowd"];
  point_at(tab["x"].get<double>() + 2 * tab["w"].get<double>(), size[1].get<double>() / 2);
  if (!map["widgets"].contains(widget)) xdotool({"click", "--repeat", std::to_string(to_the_top), "4"});
  for (int turns = 0; turns < most_turns && !map["widgets"].contains(widget); ++turns) {
    map = next_map();
    if (!map["widgets"].contains(widget)) xdotool({"click", "--repeat", "2", "5"});
  }
  EXPECT_TRUE(map["widgets"].contains(widget)) << widget << " is nowhere in tab " << map["tab"];
}

void WindowDriver::click_at(const glm::vec3& point) {
  const Json camera = next_map()["camera"];
  const CameraPose place{.x = camera["x"],
                         .y = camera["y"],
                         .z = camera["z"],
                         .yaw = camera["yaw"],
                         .pitch = camera["pitch"],
                         .field_of_view = camera["field_of_view"]};
  const render::CameraView view = render::view_of(camera_at(place), 1280.0F / 720.0F);
  const glm::vec4 clip = view.projection * view.view * glm::vec4(point, 1.0F);
  point_at((static_cast<double>(clip.x / clip.w) * 0.5 + 0.5) * 1280,
           (0.5 - static_cast<double>(clip.y / clip.w) * 0.5) * 720);
  button(1, true);
  button(1, false);
}

void WindowDriver::hold(const std::string& name) {
  xdotool({"keydown", name});
  next_map();
}

void WindowDriver::let_go(const std::string& name) {
  xdotool({"keyup", name});
  next_map();
}

void WindowDriver::press(const std::string& name) {
  hold(name);
  let_go(name);
}

void WindowDriver::type(const std::string& text) { xdotool({"type", text}); }

void WindowDriver::drop(const std::string& file) {
  ASSERT_TRUE(drop_file(display_->name(), file, soon())) << "the window took no file";
}

void WindowDriver::type_into(const std::string& widget, const std::string& text) {
  click(widget);
  wait_for("a text field that takes keys", [](const Json& map) { return map["typing"].get<bool>(); });
  type(text);
  press("Return");
}

}  // namespace throng::app
