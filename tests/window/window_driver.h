#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/own_folder.h"
#include "tests/window/child_process.h"
#include "tests/window/display.h"

namespace throng::app {

/// The real program in a real window on a display of its own, driven by mouse and keyboard. The test reads what it does
/// from the ui map (app/window/panel/controls/ui_map.h) that it writes each frame. Every wait is for a state, none for
/// a time.
class WindowDriver : public testing::Test {
 protected:
  using Json = nlohmann::json;

  void SetUp() override;

  /// Waits for a ui map for which `holds` is true, and returns it. Fails the test, naming `what`, if that never
  /// happens.
  Json wait_for(const std::string& what, const std::function<bool(const Json&)>& holds);
  /// Returns the map of a frame that begins after now.
  Json next_map(int frames = 2);

  void click(const std::string& widget);
  /// Presses in the middle of a widget and lets go at a share of its width.
  void drag(const std::string& widget, double share);
  /// Presses in the middle of one widget and lets go in the middle of another.
  void drag_to(const std::string& widget, const std::string& other);
  /// Turns the wheel down, as many steps.
  void scroll_down_at(double x, double y, int steps);
  /// Presses and lets go where the picture shows a point of the world, in metres.
  void click_at(const glm::vec3& point);
  /// Presses a key. `name` is what X11 calls it: space, Escape, w, F1.
  void press(const std::string& name);
  void hold(const std::string& name);
  void let_go(const std::string& name);
  void type(const std::string& text);
  /// Drops a file on the window.
  void drop(const std::string& file);
  void type_into(const std::string& widget, const std::string& text);
  void point_at(double x, double y);
  void button(int number, bool down);
  void xdotool(const std::vector<std::string>& words);

  /// Waits for a message that has these words.
  Json wait_for_message(const std::string& words);
  /// Fills a folder with plain models of these names, and returns its path.
  std::string folder_of_models(const std::vector<std::string>& names);

  void open_tab(const std::string& name);
  /// Turns the wheel over the panel until a widget of the tab is in sight.
  void bring_into_sight(const std::string& widget);
  /// Does the same, and clicks at the widget or types into it.
  void click_in_tab(const std::string& widget);
  void type_in_tab(const std::string& widget, const std::string& text);

  /// Returns the options that the program is started with.
  virtual std::vector<std::string> options() const { return {"--agents", "50", "--size", "1280x720"}; }
  /// Returns the pixels of the display.
  virtual glm::ivec2 screen() const { return usual_screen; }
  /// Starts the program with other options, after the end of the one that ran.
  void start_program(const std::vector<std::string>& options);

  ChildProcess& program() { return *program_; }
  /// Returns what DISPLAY says.
  const std::string& display() const { return display_->name(); }
  /// Returns the folder in which the program works. At first it has only what the driver keeps there.
  const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  void start_display();

  throng::test::OwnFolder folder_;
  std::unique_ptr<Display> display_;
  std::unique_ptr<ChildProcess> program_;
};

}  // namespace throng::app
