#include "tests/app/window/panel/overlay_driver.h"

#include <algorithm>
#include <utility>

namespace throng::app {
OverlayDriver::OverlayDriver(const std::string& fonts)
    : overlay(fonts, 1, Tuning(),
              {.get = [this] { return clipboard; }, .set = [this](const std::string& text) { clipboard = text; }}),
      report(full_report()) {
  frames(2);
}

Requests OverlayDriver::frames(int count) {
  Requests all;
  for (int i = 0; i < count; ++i) {
    overlay.begin_frame(width, shown_height, 1.0 / 60, input.next_frame());
    const Requests requests = overlay.build(report, tuning);
    for (const Request& request : requests) {
      if (const auto* const values = as<Apply>(request)) tuning = values->tuning;
      if (const auto* const seek = as<Seek>(request)) report.tracks->clock = seek->clock;
      if (const auto* const roles = as<SetRoles>(request)) report.role_clips = roles->clips;
      all.ask(request);
    }
  }
  return all;
}

Requests OverlayDriver::click(const std::string& widget) {
  point_at(widget, 0.5F);
  button(true);
  button(false);
  return frames();
}

void OverlayDriver::double_click(const std::string& widget) {
  point_at(widget, 0.5F);
  for (const bool down : {true, false, true, false}) button(down);
  frames();
}

void OverlayDriver::drag(const std::string& widget, float share) {
  point_at(widget, 0.5F);
  button(true);
  point_at(widget, share);
  frames();
  button(false);
  frames(20);  // long enough that the next drag is no double click
}

Requests OverlayDriver::drag_to(const std::string& widget, const std::string& other) {
  point_at(widget, 0.5F);
  button(true);
  frames();
  point_at(other, 0.5F);
  frames();
  button(false);
  return frames(20);
}

Requests OverlayDriver::press(Key key) {
  hold(key);
  let_go(key);
  return frames();
}

void OverlayDriver::hold(Key key) { input.push({.kind = InputEvent::Kind::key, .key = key, .down = true}); }

void OverlayDriver::let_go(Key key) { input.push({.kind = InputEvent::Kind::key, .key = key, .down = false}); }

void OverlayDriver::type(const std::string& text) {
  for (const char letter : text) {
    input.push({.kind = InputEvent::Kind::character, .character = static_cast<char32_t>(letter)});
  }
  frames();
}

void OverlayDriver::point_at(float x, float y) { input.push({.kind = InputEvent::Kind::pointer, .x = x, .y = y}); }

void OverlayDriver::point_at(const std::string& widget, float share) {
  const UiRectangle* const place = find(widget);
  ASSERT_NE(place, nullptr) << "no widget is called " << widget;
  point_at(place->x + share * place->width, place->y + place->height / 2);
}

const UiRectangle* OverlayDriver::find(const std::string& widget) const {
  const auto& all = overlay.ui_map().widgets;
  const auto found = std::ranges::find(all, widget, &std::pair<std::string, UiRectangle>::first);
  return found == all.end() ? nullptr : &found->second;
}

const std::string* OverlayDriver::why_idle(const std::string& row) const {
  const auto& all = overlay.ui_map().idle;
  const auto found = std::ranges::find(all, row, &std::pair<std::string, std::string>::first);
  return found == all.end() ? nullptr : &found->second;
}

void OverlayDriver::button(bool down) { input.push({.kind = InputEvent::Kind::button, .down = down}); }

FrameReport full_report() {
  FrameReport report;
  report.characters = {"mannequin (built in)"};
  report.has_built_in_cast = true;
  report.notice = "A line worth reading.";
  report.agents = 1000;
  report.visible = report.drawn = 600;
  report.frame_ms_history.assign(240, 15);
  report.update_ms_history.assign(240, 3);
  report.agents_by_interval = {300, 200, 100};
  report.agents_by_bone_level = {200, 200, 100, 100};
  report.level_bone_counts = {4, 3, 2, 1};
  report.bones = {{.name = "hips", .depth = 0, .parent = -1, .lod = {.bone = 0, .error_metres = 0.09F, .level = 3}},
                  {.name = "spine", .depth = 1, .parent = 0, .lod = {.bone = 1, .error_metres = 0.04F, .level = 2}},
                  {.name = "hand", .depth = 2, .parent = 1, .lod = {.bone = 2, .error_metres = 0.012F, .level = 1}},
                  {.name = "finger", .depth = 3, .parent = 2, .lod = {.bone = 3, .error_metres = 0.002F, .level = 0}}};
  report.clip_names = {"Idle", "Walking_A", "Running_A"};
  report.role_clips[index_of(Role::stand)] = 0;
  report.role_clips[index_of(Role::walk)] = 1;
  report.suggested_role_clips = report.role_clips;
  report.wardrobe.tuning = {.bodies = {{"man", 46}, {"woman", 46}, {"child", 10}},
                            .styles = {{"casual", 10}, {"office", 3}}};
  report.wardrobe.standard = report.wardrobe.tuning;
  report.wardrobe.file = "assets/cast.json";
  report.wardrobe.holding = 312;
  report.schedule.pus = 2;
  report.hardware_threads = 4;
  report.pu.resize(2);
  const std::vector<anim::TraceSpan> spans = {
      {.begin = 0, .end = 100, .bytes_in = 0, .bytes_out = 0, .transfers = 0, .kind = anim::TraceSpan::Kind::fetch},
      {.begin = 100,
       .end = 900,
       .bytes_in = 0,
       .bytes_out = 0,
       .transfers = 0,
       .kind = anim::TraceSpan::Kind::compute}};
  for (const int frame : {1, 2}) {
    report.timeline.push_back({.frame = frame,
                               .time = {.start = {}, .milliseconds = 1, .first_tick = 0, .last_tick = 1000},
                               .lanes = {spans, spans}});
  }
  return report;
}

}  // namespace throng::app
