#include "app/window_loop.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

#include "app/atomic_file.h"
#include "app/data_folder.h"
#include "app/fly_camera.h"
#include "app/frame_reporter.h"
#include "app/overlay/overlay.h"
#include "app/window_input.h"

namespace throng::app {
namespace {

constexpr double longest_step = 0.1;  // seconds: a breakpoint or a dragged window does not make the crowd jump
constexpr double single_step = 1.0 / 60.0;

class WindowLoop {
 public:
  WindowLoop(Show& show, const DemoOptions& options)
      : show_(show),
        options_(options),
        tuning_(show.stage().tuning()),
        accepted_(tuning_),
        input_(show.context().window()),
        overlay_(fonts_folder(options), options.ui_scale, tuning_, input_.clipboard()),
        fly_camera_(place_of(show.camera)),
        reporter_(show) {
    overlay_.set_hidden(options.hide_ui);
    overlay_.show_tab(options.ui_tab);
  }

  anim::Status run() {
    const render::Status prepared = show_.renderer().prepare_overlay();
    if (!prepared) return anim::Error{prepared.error().message};
    for (int frame = 1; !done_ && (!options_.frames_given || frame <= options_.frames); ++frame) {
      run_frame();
      if (frame == 1) announce();
    }
    return anim::Done{};
  }

 private:
  using Clock = std::chrono::steady_clock;

  static std::filesystem::path fonts_folder(const DemoOptions& options) {
    const auto fonts = find_data(data_folders(options.data), "assets/fonts");
    return fonts ? *fonts : std::filesystem::path();
  }

  // Programs that drive the window wait for this line.
  static void announce() {
    std::puts("READY");
    std::fflush(stdout);
  }

  void run_frame() {
    const Clock::time_point now = Clock::now();
    const double seconds = std::min(std::chrono::duration<double>(now - last_frame_).count(), longest_step);
    last_frame_ = now;
    fit_to_window();
    const InputFrame& input = input_.next_frame();
    const Clock::time_point overlay_start = Clock::now();
    overlay_.begin_frame(show_.width, show_.height, seconds, input);
    fly(input, static_cast<float>(seconds));
    reporter_.see_from(fly_camera_.place());
    const OverlayCommands commands = overlay_.build(reporter_.report(), tuning_);
    show_.add_overlay_time(std::chrono::duration<double, std::milli>(Clock::now() - overlay_start).count());
    obey(commands);
    apply(commands.exact_crowd ? without_level_of_detail(tuning_) : tuning_);
    show_.camera = fly_camera_.camera();
    show_.animate(step(seconds, commands.step));
    if (!tuning_.paused) show_.watch_for_rewind();
    if (show_.films) fly_camera_.set_camera(show_.camera);
    present();
    if (commands.screenshot) take_screenshot();
    const double frame_ms = std::chrono::duration<double, std::milli>(Clock::now() - now).count();
    reporter_.update(show_, fly_camera_.place(), frame_ms, notice_.empty() ? show_.notice : notice_);
    write_ui_map();
    done_ = commands.quit || input_.asked_to_close();
  }

  // Whoever takes the camera in hand has it from then on.
  void fly(const InputFrame& input, float seconds) {
    const render::Camera before = fly_camera_.camera();
    fly_camera_.update(input, {!overlay_.uses_pointer(), !overlay_.uses_keyboard()}, seconds);
    if (fly_camera_.camera() != before) show_.films = false;
  }

  anim::Ticks step(double seconds, bool single) const {
    if (tuning_.paused) return single ? anim::to_ticks(single_step) : 0;
    return anim::to_ticks(options_.dt.value_or(seconds) * static_cast<double>(tuning_.time_scale));
  }

  // A minimised window has no pixels: the crowd goes on, unseen.
  void fit_to_window() {
    const glm::ivec2 size = show_.context().framebuffer_size();
    minimised_ = size.x <= 0 || size.y <= 0;
    if (minimised_ || size == glm::ivec2(show_.width, show_.height)) return;
    show_.renderer().set_size(size);
    show_.width = size.x;
    show_.height = size.y;
  }

  void present() {
    if (minimised_) return;
    show_.draw();
    show_.renderer().draw_overlay(*overlay_.draw_data());
    show_.renderer().present();
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
    if (commands.frame_crowd) {
      show_.films = false;
      const CrowdSphere crowd = bounding_sphere(show_.stage().crowd());
      const float aspect = static_cast<float>(show_.width) / static_cast<float>(show_.height);
      fly_camera_.set_camera(render::frame_sphere(fly_camera_.camera(), crowd.centre, crowd.radius, aspect));
    }
    if (commands.select_at) show_.select_at(commands.select_at->x, commands.select_at->y);
    if (commands.deselect) show_.deselect();
    if (commands.push_over) {
      if (const anim::Status pushed = show_.push_selected(); !pushed) notice_ = pushed.error().message;
    }
    if (commands.hold_at) show_.hold_selected_clip(*commands.hold_at);
    if (commands.let_go) show_.let_go_of_clip();
    if (commands.rewind) {
      if (const anim::Status gone = show_.rewind(); !gone) notice_ = gone.error().message;
    }
    const std::size_t character = reporter_.report().character;
    if (commands.roles) show_.set_roles(character, *commands.roles);
    if (commands.save_roles) say_where(show_.save_roles(character));
    obey_bone_lod(commands, character);
    if (!commands.models.empty()) replace_models(commands.models);
    if (commands.character) reporter_.describe_character(show_, *commands.character);
    if (!commands.copy_camera) return;
    const std::string option = camera_option(fly_camera_.place());
    input_.clipboard().set(option);
    std::puts(option.c_str());
    std::fflush(stdout);
    notice_ = "Copied: " + option;
  }

  void replace_models(const std::vector<std::string>& files) {
    const anim::Status replaced = show_.replace_models(files);
    if (replaced) reporter_.describe_characters(show_);
    notice_ = replaced ? "" : replaced.error().message;
  }

  void obey_bone_lod(const OverlayCommands& commands, std::size_t character) {
    if (commands.bone_lod) {
      const anim::Status set = show_.set_bone_lod(character, *commands.bone_lod);
      notice_ = set ? "" : set.error().message;
      reporter_.describe_character(show_, character);
    }
    if (commands.export_lod) say_where(show_.export_lod(character));
    if (commands.save_bone_lod) say_where(show_.save_bone_lod(character));
  }

  void say_where(const anim::Result<std::filesystem::path>& written) {
    notice_ = written ? "Wrote " + written->string() : written.error().message;
  }

  void take_screenshot() {
    std::string file;
    do file = "throng-" + std::to_string(++screenshots_) + ".png";
    while (std::filesystem::exists(file));
    const render::Status written = render::write_png(show_.renderer().read_image(), file);
    notice_ = written ? "Wrote " + file : written.error().message;
  }

  void write_ui_map() {
    if (options_.ui_map.empty()) return;
    const anim::Status written =
        write_whole_file(options_.ui_map, to_json(overlay_.ui_map(), tuning_, reporter_.report()));
    if (!written) notice_ = written.error().message;
  }

  Show& show_;
  const DemoOptions& options_;
  Tuning tuning_;
  Tuning accepted_;  // the last that could be
  WindowInput input_;
  Overlay overlay_;
  FlyCamera fly_camera_;
  FrameReporter reporter_;
  Clock::time_point last_frame_ = Clock::now();
  std::string notice_;
  int screenshots_ = 0;
  bool minimised_ = false;
  bool done_ = false;
};

}  // namespace

anim::Status run_window(Show& show, const DemoOptions& options) { return WindowLoop(show, options).run(); }

}  // namespace throng::app
