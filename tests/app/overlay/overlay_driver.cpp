#include "tests/app/overlay/overlay_driver.h"

#include <gtest/gtest.h>

namespace throng::app {
namespace {

void add(CameraCommands& all, const CameraCommands& commands) {
  all.home |= commands.home;
  all.change_follow |= commands.change_follow;
  if (commands.named) all.named = commands.named;
  if (commands.fly_speed) all.fly_speed = commands.fly_speed;
  if (commands.keep_bookmark) all.keep_bookmark = commands.keep_bookmark;
  if (commands.go_to_bookmark) all.go_to_bookmark = commands.go_to_bookmark;
}

void add(ReplayCommands& all, const ReplayCommands& commands) {
  all.change_pause |= commands.change_pause;
  all.change_loop |= commands.change_loop;
  if (commands.step != 0) all.step = commands.step;
  if (commands.go_to) all.go_to = commands.go_to;
  if (commands.speed) all.speed = commands.speed;
}

}  // namespace

namespace {

void add(ViewerCommands& all, const ViewerCommands& more) {
  all.view_selected |= more.view_selected;
  all.leave |= more.leave;
  all.face_front |= more.face_front;
  all.apply_preview |= more.apply_preview;
  if (more.view) all.view = more.view;
  if (more.settings) all.settings = more.settings;
  if (more.scrub) all.scrub = more.scrub;
}

}  // namespace

OverlayDriver::OverlayDriver(const std::string& fonts)
    : overlay(fonts, 1, Tuning(),
              {.get = [this] { return clipboard; }, .set = [this](const std::string& text) { clipboard = text; }}),
      report(full_report()) {
  frames(2);
}

OverlayCommands OverlayDriver::frames(int count) {
  OverlayCommands all;
  for (int i = 0; i < count; ++i) {
    overlay.begin_frame(width, shown_height, 1.0 / 60, input.next_frame());
    const OverlayCommands commands = overlay.build(report, tuning);
    all.step |= commands.step;
    all.frame_crowd |= commands.frame_crowd;
    all.copy_camera |= commands.copy_camera;
    all.screenshot |= commands.screenshot;
    all.reload_shaders |= commands.reload_shaders;
    all.quit |= commands.quit;
    all.record |= commands.record;
    all.save_roles |= commands.save_roles;
    all.save_body |= commands.save_body;
    all.deselect |= commands.deselect;
    all.push_over |= commands.push_over;
    all.exact_crowd |= commands.exact_crowd;
    all.let_go |= commands.let_go;
    all.copy_command_line |= commands.copy_command_line;
    all.save_bone_lod |= commands.save_bone_lod;
    all.export_lod |= commands.export_lod;
    all.stop_sweep |= commands.stop_sweep;
    all.look_at_last_frames |= commands.look_at_last_frames;
    if (commands.look_at_frame) all.look_at_frame = commands.look_at_frame;
    if (commands.rewind) all.rewind = commands.rewind;
    if (commands.sweep) all.sweep = commands.sweep;
    add(all.cameras, commands.cameras);
    add(all.replay, commands.replay);
    if (commands.track_clock) report.tracks->clock = *(all.track_clock = commands.track_clock);
    if (commands.bone_lod) all.bone_lod = commands.bone_lod;
    if (commands.hold_at) all.hold_at = commands.hold_at;
    if (commands.save_preset) all.save_preset = commands.save_preset;
    if (commands.load_preset) all.load_preset = commands.load_preset;
    if (commands.load_into_other) all.load_into_other = commands.load_into_other;
    if (!commands.hint.empty()) all.hint = commands.hint;
    if (commands.delete_preset) all.delete_preset = commands.delete_preset;
    if (!commands.models.empty()) all.models = commands.models;
    if (commands.select_at) all.select_at = commands.select_at;
    if (commands.body) all.body = commands.body;
    if (commands.share) all.share = commands.share;
    if (commands.wardrobe.cast) all.wardrobe.cast = commands.wardrobe.cast;
    if (commands.wardrobe.save) all.wardrobe.save = commands.wardrobe.save;
    if (commands.wardrobe.load) all.wardrobe.load = commands.wardrobe.load;
    if (commands.everyone) all.everyone = commands.everyone;
    if (commands.placement) all.placement = commands.placement;
    if (commands.character) all.character = commands.character;
    add(all.viewer, commands.viewer);
    if (commands.roles) report.role_clips = *(all.roles = commands.roles);
  }
  return all;
}

OverlayCommands OverlayDriver::click(const std::string& widget) {
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

OverlayCommands OverlayDriver::drag_to(const std::string& widget, const std::string& other) {
  point_at(widget, 0.5F);
  button(true);
  frames();
  point_at(other, 0.5F);
  frames();
  button(false);
  return frames(20);
}

OverlayCommands OverlayDriver::press(Key key) {
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
  const UiRectangle* const place = overlay.ui_map().find(widget);
  ASSERT_NE(place, nullptr) << "no widget is called " << widget;
  point_at(place->x + share * place->width, place->y + place->height / 2);
}

void OverlayDriver::button(bool down) { input.push({.kind = InputEvent::Kind::button, .down = down}); }

FrameReport full_report() {
  FrameReport report;
  report.characters = {"mannequin (built in)"};
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
