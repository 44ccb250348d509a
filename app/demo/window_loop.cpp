#include "app/demo/window_loop.h"

#include <algorithm>
#include <chrono>
#include <string>

#include "app/demo/frame_reporter.h"
#include "app/demo/stop_signals.h"
#include "app/demo/unkept_values.h"
#include "app/demo/window_camera.h"
#include "app/demo/window_input.h"
#include "app/demo/window_replay.h"
#include "app/files/data_folder.h"
#include "app/overlay/overlay.h"
#include "app/report/tuning_sweep.h"
#include "app/settings/preset.h"
#include "app/show/kept_choices.h"
#include "engine/files/output_file.h"

namespace throng::app {
namespace {

constexpr double longest_step = 0.1;  // seconds: a breakpoint or a dragged window does not make the crowd jump
constexpr double single_step = 1.0 / 60.0;

class WindowLoop {
 public:
  WindowLoop(Show& show, const DemoOptions& options, Replay* replay)
      : show_(show),
        options_(options),
        tuning_(show.stage().tuning()),
        accepted_(tuning_),
        unkept_(tuning_),
        input_(show.painter().context().window()),
        overlay_(fonts_folder(options), options.ui_scale, tuning_, input_.clipboard()),
        camera_(show),
        reporter_(show) {
    if (replay != nullptr) replay_.emplace(*replay);
    overlay_.set_hidden(options.hide_ui);
    reporter_.set_preset_names(preset_names());
    show_.keep_moments();
    overlay_.show_tab(options.ui_tab);
  }

  anim::Status run() {
    if (anim::Status prepared = show_.painter().renderer().prepare_overlay(); !prepared) return prepared;
    for (int frame = 1; !done_ && (!options_.frames_given || frame <= options_.frames); ++frame) {
      run_frame();
      if (frame == 1) announce();
    }
    return failed_ && replay_ ? replay_->outcome() : failed_;
  }

 private:
  using Clock = std::chrono::steady_clock;

  static std::filesystem::path fonts_folder(const DemoOptions& options) {
    const auto fonts = find_data(data_folders(options.data), "assets/fonts");
    return fonts ? *fonts : std::filesystem::path();
  }

  // Programs that drive the window wait for this line.
  static void announce() { static_cast<void>(print("READY\n")); }

  void run_frame() {
    const Clock::time_point now = Clock::now();
    const double seconds = std::min(std::chrono::duration<double>(now - last_frame_).count(), longest_step);
    last_frame_ = now;
    fit_to_window();
    const InputFrame& input = input_.next_frame();
    const Clock::time_point overlay_start = Clock::now();
    overlay_.begin_frame(show_.width, show_.height, seconds, input);
    if (!replay_) fly(input, static_cast<float>(seconds));
    reporter_.see_from(camera_.place());
    camera_.report(reporter_.cameras());
    const OverlayCommands commands = overlay_.build(reporter_.report(), tuning_);
    show_.figures().add_overlay(std::chrono::duration<double, std::milli>(Clock::now() - overlay_start).count());
    if (replay_) {
      repeat(commands.replay, seconds);
    } else {
      obey(commands);
      apply_what_is_wanted(commands.exact_crowd);
      camera_.hand_over(show_);
      show_.animate(step(seconds, commands.step));
      measure_for_sweep();
    }
    camera_.take_back(show_);
    present();
    if (commands.screenshot) take_screenshot();
    const double frame_ms = std::chrono::duration<double, std::milli>(Clock::now() - now).count();
    reporter_.update(show_, camera_.place(), frame_ms, notice_.empty() ? show_.notice : notice_);
    write_ui_map();
    if (!show_.recording_outcome()) notice_ = show_.recording_outcome().error().message;
    done_ = done_ || (commands.quit && may_leave()) || input_.asked_to_close() || asked_to_stop() != 0;
  }

  bool may_leave() {
    if (replay_ || !unkept_.ask_about(tuning_)) return true;
    notice_ = "The values are in no preset. Esc leaves them behind; the tab Presets keeps them.";
    overlay_.set_hidden(false);  // which shows the notice
    return false;
  }

  // What was recorded happens, and nothing else.
  void repeat(const ReplayCommands& commands, double seconds) {
    replay_->obey(commands);
    replay_->advance(show_, seconds);
    reporter_.report_replay(replay_->report());
    tuning_ = show_.stage().tuning();
  }

  void toggle_recording() {
    if (show_.is_recording()) {
      const anim::Status stopped = show_.stop_recording();
      notice_ = stopped ? "Wrote " + recording_ : stopped.error().message;
      return;
    }
    recording_ = unused_file(".rec", recordings_);
    const anim::Status started = show_.start_recording(recording_);
    notice_ = started ? "The crowd begins anew and is recorded; R writes " + recording_ : started.error().message;
  }

  // "throng-1.png", in the working folder.
  static std::string unused_file(const char* ending, int& number) {
    std::string file;
    do file = "throng-" + std::to_string(++number) + ending;
    while (std::filesystem::exists(file));
    return file;
  }

  void fly(const InputFrame& input, float seconds) {
    const FlyControls free{.pointer_free = !overlay_.uses_pointer(), .keyboard_free = !overlay_.uses_keyboard()};
    camera_.steer(show_, input, free, seconds);
  }

  anim::Ticks step(double seconds, bool single) const {
    if (tuning_.paused) return single ? anim::to_ticks(single_step) : anim::Ticks{};
    return anim::to_ticks(options_.dt.value_or(seconds) * static_cast<double>(tuning_.time_scale));
  }

  // A minimised window has no pixels: the crowd goes on, unseen.
  void fit_to_window() {
    const glm::ivec2 size = show_.painter().context().framebuffer_size();
    minimised_ = size.x <= 0 || size.y <= 0;
    if (minimised_ || size == glm::ivec2(show_.width, show_.height)) return;
    const anim::Status set = show_.painter().renderer().set_size(size);
    if (!set) notice_ = set.error().message;  // the picture keeps its size and is stretched
    if (!set) return;
    show_.width = size.x;
    show_.height = size.y;
  }

  void present() {
    if (minimised_) return;
    if (const anim::Status drawn = show_.draw(); !drawn) {
      notice_ = drawn.error().message;  // a person can take back what was too much, but for the first picture
      if (show_.stage().frame() <= 1) failed_ = drawn, done_ = true;
    }
    show_.painter().renderer().draw_overlay(*overlay_.draw_data());
    show_.painter().renderer().present();
  }

  void apply_what_is_wanted(bool exact_crowd) {
    if (!sweep_.began_with(tuning_)) sweep_.stop();
    while (sweep_.runs() && !exact_crowd) {
      const Tuning stop = sweep_.tuning();
      const anim::Status applied = stop == show_.stage().tuning() ? anim::Done{} : show_.apply(stop);
      if (applied) return;
      sweep_.refuse(applied.error().message);
    }
    apply(exact_crowd ? without_level_of_detail(tuning_) : tuning_);
  }

  // Frames in which nobody was posed, or the exact crowd was, tell nothing.
  void measure_for_sweep() {
    const anim::AnimationSystem& system = show_.stage().system();
    const bool tells = sweep_.runs() && show_.stage().tuning() == sweep_.tuning();
    if (tells && system.figures().report().agents_updated > 0) sweep_.add(cost_of_last_update(system));
    reporter_.show_sweep(sweep_.curve());
  }

  void obey_sweep(const OverlayCommands& commands) {
    if (commands.sweep) sweep_.start(*commands.sweep, tuning_, reporter_.report().hardware_threads);
    if (commands.stop_sweep) sweep_.stop();
  }

  void apply(const Tuning& tuning) {
    if (tuning == show_.stage().tuning()) return;
    const anim::Status applied = show_.apply(tuning);
    notice_ = applied ? "" : applied.error().message;
    if (applied) {
      accepted_ = tuning_;
    } else {
      tuning_ = accepted_;
    }
  }

  void obey(const OverlayCommands& commands) {
    if (commands.frame_crowd) camera_.frame_crowd(overlay_.crowd_area(), show_);
    camera_.obey(commands.cameras, show_);
    if (commands.select_at) show_.hands().select_at(commands.select_at->x, commands.select_at->y);
    if (commands.deselect) show_.hands().select({});
    if (commands.push_over) {
      if (const anim::Status pushed = show_.hands().push_selected(); !pushed) notice_ = pushed.error().message;
    }
    obey_hands(commands);
    obey_sweep(commands);
    obey_presets(commands);
    const std::size_t character = reporter_.report().character;
    if (commands.share) show_.set_share(commands.share->character, commands.share->share);
    if (commands.roles) show_.set_roles(character, *commands.roles);
    if (commands.save_roles) say_where(save_roles(show_.stage().characters()[character]));
    obey_body(commands, character);
    obey_bone_lod(commands, character);
    if (commands.record) toggle_recording();
    if (commands.character) reporter_.describe_character(show_, *commands.character);
    if (commands.copy_camera) copy(camera_option(camera_.place()));
    if (commands.reload_shaders) reload_shaders();
  }

  void obey_hands(const OverlayCommands& commands) {
    if (commands.hold_at) show_.hands().hold_selected_clip(*commands.hold_at);
    if (commands.let_go) show_.hands().let_go_of_clip();
    if (commands.rewind) {
      if (const anim::Status gone = show_.rewind(); !gone) notice_ = gone.error().message;
    }
    if (!commands.models.empty()) replace_models(commands.models);
  }

  void obey_presets(const OverlayCommands& commands) {
    if (commands.save_preset) {
      const std::filesystem::path file = preset_file(*commands.save_preset);
      const anim::Status written = write_preset(file, {tuning_, camera_.place()});
      notice_ = written ? "Wrote " + file.string() : written.error().message;
      if (written) unkept_.keep(tuning_);
    }
    if (commands.load_preset) load_preset(preset_file(*commands.load_preset));
    if (commands.delete_preset) {
      std::error_code failed;
      std::filesystem::remove(preset_file(*commands.delete_preset), failed);
      notice_ = failed ? preset_file(*commands.delete_preset).string() + ": " + failed.message() : "";
    }
    if (commands.save_preset || commands.delete_preset) reporter_.set_preset_names(preset_names());
    if (commands.copy_command_line) copy(command_line(tuning_, Tuning(), camera_.place()));
  }

  void load_preset(const std::filesystem::path& file) {
    const anim::Result<Preset> preset = read_preset(file);
    notice_ = preset ? "" : preset.error().message;
    if (!preset) return;
    const LodInspection look = tuning_.inspection;
    tuning_ = preset->tuning;
    tuning_.inspection = look;
    unkept_.keep(tuning_);
    if (preset->camera) camera_.put(*preset->camera, show_);
  }

  void copy(const std::string& options) {
    input_.clipboard().set(options);
    static_cast<void>(print(options + "\n"));  // a window may have nobody who reads it
    notice_ = "Copied: " + options;
  }

  void replace_models(const std::vector<std::string>& files) {
    const anim::Status replaced = show_.replace_models(files);
    if (replaced) reporter_.describe_characters(show_);
    notice_ = replaced ? "" : replaced.error().message;
  }

  void obey_body(const OverlayCommands& commands, std::size_t character) {
    if (commands.body) {
      const anim::Status set = show_.set_rig(character, commands.body->choices);
      reporter_.describe_character(show_, character);
      if (!set) reporter_.refuse_body(*commands.body, set.error().message);
      notice_ = set || commands.body->changed ? "" : set.error().message;
    }
    if (commands.save_body) say_where(save_rig(show_.stage().characters()[character]));
  }

  void obey_bone_lod(const OverlayCommands& commands, std::size_t character) {
    if (commands.bone_lod) {
      const anim::Status set = show_.set_bone_lod(character, *commands.bone_lod);
      notice_ = set ? "" : set.error().message;
      reporter_.describe_character(show_, character);
    }
    if (commands.export_lod) say_where(export_lod(show_, character));
    if (commands.save_bone_lod) say_where(save_bone_lod(show_.stage().characters()[character]));
  }

  void say_where(const anim::Result<std::filesystem::path>& written) {
    notice_ = written ? "Wrote " + written->string() : written.error().message;
  }

  void take_screenshot() {
    const std::string file = unused_file(".png", screenshots_);
    const anim::Status written = render::write_png(show_.painter().renderer().read_image(), file);
    notice_ = written ? "Wrote " + file : written.error().message;
  }

  void reload_shaders() {
    const anim::Status reloaded = show_.painter().renderer().reload_shaders();
    notice_ = reloaded ? "Built the shaders again" : reloaded.error().message;
  }

  void write_ui_map() {
    if (options_.ui_map.empty()) return;
    const anim::Status written = write_whole_file(
        options_.ui_map, to_json(overlay_.ui_map(), tuning_, reporter_.report()), OutputFile::Sync::system);
    if (!written) notice_ = written.error().message;
  }

  Show& show_;
  const DemoOptions& options_;
  Tuning tuning_;
  Tuning accepted_;  // the last that could be
  UnkeptValues unkept_;
  WindowInput input_;
  Overlay overlay_;
  WindowCamera camera_;
  FrameReporter reporter_;
  TuningSweep sweep_;
  Clock::time_point last_frame_ = Clock::now();
  std::optional<WindowReplay> replay_;  // none: people say what happens
  std::string notice_;
  std::string recording_;  // its file
  anim::Status failed_ = anim::Done{};
  int screenshots_ = 0;
  int recordings_ = 0;
  bool minimised_ = false;
  bool done_ = false;
};

}  // namespace

anim::Status run_window(Show& show, const DemoOptions& options, Replay* replay) {
  return WindowLoop(show, options, replay).run();
}

}  // namespace throng::app
