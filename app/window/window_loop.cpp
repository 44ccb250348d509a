#include "app/window/window_loop.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "app/settings/preset.h"
#include "app/show/figures/run_figures.h"
#include "app/show/painter.h"
#include "app/show/recording/recorder.h"
#include "app/show/request/crowd_file.h"
#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/window/full_screen.h"
#include "app/window/panel/overlay.h"
#include "app/window/stop_signals.h"
#include "app/window/window_picture.h"
#include "app/window/window_replay.h"
#include "app/window/window_requests.h"
#include "app/window/window_session.h"
#include "engine/base/files/output_file.h"

namespace throng::app {
namespace {

constexpr double longest_step = 0.1;  // seconds: a breakpoint or a dragged window does not make the crowd jump
constexpr double single_step = 1.0 / 60.0;
constexpr double unseen_step = 0.1;    // seconds between frames of a window out of sight
constexpr double resting_step = 0.25;  // of a crowd that stands still
constexpr int frames_until_rest = 120;

bool is_used(const InputFrame& input) {
  return input.buttons_down.any() || input.keys_down.any() || !input.pressed.empty() || !input.characters.empty() ||
         !input.dropped.empty() || input.moved_x != 0.0F || input.moved_y != 0.0F || input.wheel != 0.0F;
}

class WindowLoop {
 public:
  WindowLoop(Show& show, const DemoOptions& options, Replay* replay)
      : session_(show, options),
        overlay_(fonts_folder(options.data), options.ui_scale, session_.editor.tuning(), session_.input.clipboard()) {
    if (replay != nullptr) replay_.emplace(*replay);
    overlay_.set_hidden(options.hide_ui);
    overlay_.set_panel_width(session_.first_panel_width);
    session_.reporter.report().preset_names = preset_names();
    session_.reporter.report().crowd_names = crowd_names(".");
    session_.reporter.report_recording(options.record);
    show.keep_moments();
    take_kept(options);
    overlay_.show_tab(options.ui_tab);
    session_.unsaved.keep(session_.crowd_work());
  }

  Status run() {
    const DemoOptions& options = session_.options;
    if (Status prepared = picture_.prepare(overlay_); !prepared) return prepared;
    for (int frame = 1; !done_ && (!options.frames_given || frame <= options.frames); ++frame) {
      run_frame();
      if (frame == 1) announce();
    }
    requests_.end_jobs();
    if (!replay_) session_.keep_settings(picture_.window_size(), overlay_.panel_width());
    return failed_ && replay_ ? replay_->outcome() : failed_;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void take_kept(const DemoOptions& options) {
    if (options.crowd == nullptr) return;
    requests_.take_kept(*options.crowd);
    if (options.crowd_file.empty()) return;
    session_.reporter.report().crowd = std::filesystem::path(options.crowd_file).replace_extension().string();
    session_.note_recent(options.crowd_file);
  }

  // Programs that drive the window wait for this line.
  static void announce() { static_cast<void>(print("READY\n")); }

  void run_frame() {
    Show& show = session_.show;
    FrameReporter& reporter = session_.reporter;
    wait_where_nothing_happens();
    const Clock::time_point now = Clock::now();
    const double seconds = std::min(std::chrono::duration<double>(now - last_frame_).count(), longest_time());
    last_frame_ = now;
    picture_.fit_to_window(session_.input.is_out_of_sight());
    picture_.scale(overlay_, session_.panel_scale());
    const InputFrame& input = session_.input.next_frame();
    still_frames_ = stands_still() && !is_used(input) ? still_frames_ + 1 : 0;
    const Clock::time_point overlay_start = Clock::now();
    overlay_.begin_frame(picture_.window_size().x, picture_.window_size().y, seconds, input);
    session_.camera.see_beside(overlay_.free_area(reporter.report()), picture_.window_size(), show);
    if (!replay_) fly(input, static_cast<float>(seconds));
    reporter.report().camera = session_.camera.place();
    session_.camera.report(reporter.report().cameras);
    reporter.messages().pass(seconds);
    reporter.report().can_undo_bones = session_.editor.can_undo_bones();
    reporter.report().given_up = session_.rate.given_up(session_.editor.tuning());
    reporter.report().rate_advice = session_.rate.advice(session_.editor.tuning());
    Requests requests = overlay_.build(reporter.report(), session_.shown_values());
    if (session_.input.takes_close()) requests.ask(Quit{});
    if (last_of<ToggleFullScreen>(requests) != nullptr) full_screen_.toggle();
    show.figures().add_overlay(std::chrono::duration<double, std::milli>(Clock::now() - overlay_start).count());
    if (replay_) {
      repeat(requests, seconds);
    } else {
      requests_.take(requests);
      session_.show_wanted_values(last_of<ShowExactCrowd>(requests) != nullptr);
      session_.camera.hand_over(show);
      show.animate(step(seconds, last_of<StepFrame>(requests) != nullptr));
      session_.measure_for_sweep();
    }
    session_.camera.take_back(show);
    failed_ = picture_.present(overlay_, is_used(input));
    requests_.take_after_drawing(requests);
    picture_.build_saved_shaders(now);
    keep_pace(now);
    const double frame_ms = std::chrono::duration<double, std::milli>(Clock::now() - now).count();
    const auto work = picture_.drawn_at() - now;
    if (picture_.is_seen())
      session_.rate.add_frame(std::chrono::duration<double, std::milli>(work).count(), session_.editor.tuning());
    reporter.update(show, session_.camera.place(), frame_ms);
    write_ui_map();
    reporter.messages().report(show.recorder().outcome());
    const bool leaves_replay = replay_ && last_of<Quit>(requests) != nullptr;
    done_ = !failed_ || leaves_replay || requests_.closes() || asked_to_stop() != 0;
  }

  // A limit of few frames a second does not slow the crowd down.
  double longest_time() const {
    return std::max(longest_step,
                    2.0 * std::chrono::duration<double>(least_frame_time(session_.editor.tuning())).count());
  }

  // Ends a frame no sooner than the limit lets the next one begin.
  void keep_pace(Clock::time_point began) {
    const Tuning& tuning = session_.editor.tuning();
    if (std::exchange(follows_display_, tuning.vertical_sync) != tuning.vertical_sync) {
      session_.show.painter().context().set_vertical_sync(tuning.vertical_sync);
    }
    std::this_thread::sleep_until(began + least_frame_time(tuning));
  }

  bool stands_still() const {
    return session_.editor.tuning().paused && !replay_ && session_.show.viewer() == nullptr && !session_.sweep.runs();
  }

  // A run of so many frames ends as soon as it can.
  void wait_where_nothing_happens() {
    if (session_.options.frames_given) return;
    if (!picture_.is_seen()) return WindowInput::wait(unseen_step);
    if (still_frames_ > frames_until_rest) WindowInput::wait(resting_step);
  }

  void refuse_drop(const std::string& file) {
    session_.messages().say(file + ": a replay shows what was recorded; drop it on a window without --replay",
                            Message::Kind::refused);
  }

  void refuse_video() {
    session_.messages().say(
        "A replay is made into a video without a window: throng --headless --replay FILE --video FILE.mp4",
        Message::Kind::refused);
  }

  // Recorded requests happen, and no others.
  void repeat(const Requests& requests, double seconds) {
    for (const Request& request : requests) {
      if (const auto* const asked = std::get_if<ReplayRequest>(&request)) replay_->take(*asked);
      if (const auto* const drop = as<OpenFiles>(request)) refuse_drop(drop->files.front());
      if (const auto* const output = as<SetOutput>(request)) session_.reporter.report().output = output->choices;
      if (as<MakeVideo>(request) != nullptr) refuse_video();
    }
    replay_->advance(session_.show, seconds);
    session_.reporter.report().replay = replay_->report();
    session_.editor.follow();
  }

  void fly(const InputFrame& input, float seconds) {
    const FlyControls free{.pointer_free = !overlay_.uses_pointer(), .keyboard_free = !overlay_.uses_keyboard()};
    session_.camera.steer(session_.show, input, free, seconds);
  }

  Ticks step(double seconds, bool single) const {
    const Tuning& tuning = session_.editor.tuning();
    if (session_.show.viewer() != nullptr) return to_ticks(session_.options.dt.value_or(seconds));
    if (tuning.paused) return single ? to_ticks(single_step) : Ticks{};
    return to_ticks(session_.options.dt.value_or(seconds) * static_cast<double>(tuning.time_scale));
  }

  void write_ui_map() {
    const std::string& file = session_.options.ui_map;
    if (file.empty()) return;
    session_.messages().report(
        write_whole_file(file, to_json(overlay_.ui_map(), session_.editor.tuning(), session_.reporter.report()),
                         OutputFile::Sync::system));
  }

  WindowSession session_;
  std::optional<WindowReplay> replay_;  // none: people make the requests
  Overlay overlay_;
  WindowRequests requests_{session_, overlay_};
  WindowPicture picture_{session_.show, session_.messages()};
  FullScreen full_screen_{session_.show.painter().context().window()};
  Clock::time_point last_frame_ = Clock::now();
  Status failed_ = Done{};
  bool done_ = false;
  bool follows_display_ = true;  // a window is opened so
  int still_frames_ = 0;         // in a row, in which nothing happened
};

}  // namespace

Status run_window(Show& show, const DemoOptions& options, Replay* replay) {
  return WindowLoop(show, options, replay).run();
}

}  // namespace throng::app
