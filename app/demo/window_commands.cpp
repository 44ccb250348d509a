#include "app/demo/window_commands.h"

#include <algorithm>
#include <system_error>

#include "app/character/cast_entry.h"
#include "app/demo/placed_model.h"
#include "app/demo/viewer_commands.h"
#include "app/demo/wardrobe_commands.h"
#include "app/recording/cast_options.h"
#include "app/recording/crowd_file.h"
#include "app/regression/origin.h"
#include "app/show/kept_choices.h"
#include "engine/files/output_file.h"

namespace throng::app {
namespace {

// "throng-1.png", in the working folder.
std::string unused_file(const char* ending, int& number) {
  std::string file;
  do file = "throng-" + std::to_string(++number) + ending;
  while (std::filesystem::exists(file));
  return file;
}

void give_all_places_to(std::size_t character, Show& show) {
  for (std::size_t i = 0; i < show.stage().characters().size(); ++i) {
    show.set_share(i, i == character ? most_share : least_share);
  }
}

}  // namespace

void WindowCommands::obey(const OverlayCommands& commands) {
  Show& show = session_.show;
  FrameReporter& reporter = session_.reporter;
  if (commands.frame_crowd) session_.camera.frame_crowd(overlay_.crowd_area(), show);
  session_.camera.obey(commands.cameras, show);
  if (commands.select_at) show.hands().select_at(commands.select_at->x, commands.select_at->y);
  if (commands.deselect) show.hands().select({});
  if (commands.push_over) messages().tell(show.hands().push_selected());
  obey_hands(commands);
  obey_sweep(commands);
  reporter.look_at(commands);
  obey_presets(commands);
  obey_crowd_files(commands);
  const std::size_t character = reporter.report().character;
  if (commands.placement) place_model(show, *commands.placement, messages());
  if (commands.share) show.set_share(commands.share->character, commands.share->share);
  if (commands.everyone) give_all_places_to(*commands.everyone, show);
  if (obey_wardrobe(show, character, commands.wardrobe, messages())) reporter.describe_character(show, character);
  if (commands.roles) show.set_roles(character, *commands.roles);
  messages().tell(obey_viewer(show, commands.viewer));
  if (show.viewer() != nullptr) session_.sweep.stop();  // a crowd that waits costs nothing
  if (commands.save_roles) say_where(save_roles(show.stage().characters()[character]));
  obey_body(commands, character);
  obey_bone_lod(commands, character);
  if (commands.record) toggle_recording();
  if (!commands.hint.empty()) messages().say(commands.hint, Message::Kind::refused);
  if (commands.character) reporter.describe_character(show, *commands.character);
  if (commands.copy_camera) copy(camera_option(session_.camera.place()));
  if (commands.reload_shaders) {
    messages().tell(show.painter().renderer().reload_shaders(), "Built the shaders again");
  }
}

void WindowCommands::obey_after_drawing(const OverlayCommands& commands) {
  tracks_.read_when_said(session_);
  if (commands.screenshot) take_screenshot();
}

void WindowCommands::toggle_recording() {
  Show& show = session_.show;
  const std::string file = session_.reporter.report().recording.file;
  if (show.recorder().is_recording()) {
    return messages().tell(show.stop_recording(), "Wrote " + file);
  }
  const std::string unused = unused_file(".rec", recordings_);
  if (!messages().tell(show.start_recording(unused))) return;
  session_.reporter.report_recording(unused);
  messages().say("The crowd begins anew and is recorded; R writes " + unused);
}

void WindowCommands::obey_hands(const OverlayCommands& commands) {
  Show& show = session_.show;
  if (commands.hold_at) show.hands().hold_selected_clip(*commands.hold_at);
  if (commands.let_go) show.hands().let_go_of_clip();
  if (commands.track_clock) set_track_clock(show, *commands.track_clock);
  if (commands.rewind) messages().tell(show.rewind(*commands.rewind));
  if (!commands.models.empty()) replace_models(commands.models);
}

void WindowCommands::obey_crowd_files(const OverlayCommands& commands) {
  const auto file = [](const std::string& name) { return std::filesystem::path(name + crowd_file_ending); };
  if (commands.save_crowd) save_crowd(file(*commands.save_crowd));
  if (commands.open_crowd) open_crowd(file(*commands.open_crowd));
}

void WindowCommands::save_crowd(const std::filesystem::path& file) {
  CrowdSetup setup = crowd_setup(session_.show.stage().people(), {session_.tuning, session_.camera.place()});
  setup.pair = overlay_.tuning_pair();
  setup.bookmarks = session_.camera.bookmarks();
  const anim::Status written = write_crowd_file(file, setup);
  messages().tell(written, "Wrote " + file.string());
  if (!written) return;
  session_.unkept.keep(session_.tuning);
  if (setup.pair.has_two()) session_.unkept.keep_other(setup.pair.other());
  session_.reporter.set_crowd_names(crowd_names("."));
}

void WindowCommands::open_crowd(const std::filesystem::path& file) {
  const auto setup = read_crowd_file(file);
  if (!setup) return messages().say(setup.error().message, Message::Kind::refused);
  const anim::Status replaced = session_.show.replace_crowd(setup->characters);
  if (!replaced) return messages().say(file.string() + ": " + replaced.error().message, Message::Kind::refused);
  session_.reporter.describe_characters(session_.show);
  take(setup->preset);
  take_kept(*setup);
  messages().say("Opened " + file.string());
}

void WindowCommands::take_kept(const CrowdSetup& setup) {
  overlay_.tuning_pair() = setup.pair;
  if (setup.pair.has_two()) session_.unkept.keep_other(setup.pair.other());
  session_.camera.take_bookmarks(setup.bookmarks);
}

void WindowCommands::obey_sweep(const OverlayCommands& commands) {
  if (commands.sweep) {
    session_.sweep.start(*commands.sweep, session_.tuning, session_.reporter.report().hardware_threads);
  }
  if (commands.stop_sweep) session_.sweep.stop();
}

void WindowCommands::obey_presets(const OverlayCommands& commands) {
  const CameraPlace camera = session_.camera.place();
  if (commands.save_preset) {
    const std::filesystem::path file = preset_file(*commands.save_preset);
    const anim::Status written = write_preset(file, {session_.tuning, camera});
    messages().tell(written, "Wrote " + file.string());
    if (written) session_.unkept.keep(session_.tuning, overlay_.tuning_pair());
  }
  if (commands.load_preset) load_preset(preset_file(*commands.load_preset));
  if (commands.load_into_other) load_into_other(*commands.load_into_other);
  if (commands.delete_preset) {
    const std::filesystem::path file = preset_file(*commands.delete_preset);
    std::error_code failed;
    std::filesystem::remove(file, failed);
    messages().tell(failed ? anim::Status(anim::Error{file.string() + ": " + failed.message()}) : anim::Done{},
                    "Deleted " + file.string());
  }
  if (commands.save_preset || commands.delete_preset) session_.reporter.set_preset_names(preset_names());
  if (commands.copy_command_line) copy_command_line();
}

void WindowCommands::obey_body(const OverlayCommands& commands, std::size_t character) {
  if (commands.body) {
    const anim::Status set = session_.show.set_rig(character, commands.body->choices);
    session_.reporter.describe_character(session_.show, character);
    if (!set) session_.reporter.refuse_body(*commands.body, set.error().message);
    if (!commands.body->changed) messages().tell(set);  // else the row says why
  }
  if (commands.save_body) say_where(save_rig(session_.show.stage().characters()[character]));
}

void WindowCommands::obey_bone_lod(const OverlayCommands& commands, std::size_t character) {
  if (commands.bone_lod) {
    messages().tell(session_.show.set_bone_lod(character, *commands.bone_lod));
    session_.reporter.describe_character(session_.show, character);
  }
  if (commands.export_lod) say_where(export_lod(session_.show, character));
  if (commands.save_bone_lod) say_where(save_bone_lod(session_.show.stage().characters()[character]));
}

void WindowCommands::load_preset(const std::filesystem::path& file) {
  const anim::Result<Preset> preset = read_preset(file);
  if (!preset) return messages().say(preset.error().message, Message::Kind::refused);
  take(*preset);
}

void WindowCommands::load_into_other(const std::string& name) {
  const anim::Result<Preset> preset = read_preset(preset_file(name));
  if (!preset) return messages().say(preset.error().message, Message::Kind::refused);
  overlay_.tuning_pair().take_other(preset->tuning, name);
  session_.unkept.keep_other(preset->tuning);
}

void WindowCommands::take(const Preset& preset) {
  const LodInspection look = session_.tuning.inspection;
  session_.tuning = preset.tuning;
  session_.tuning.inspection = look;
  session_.unkept.keep(session_.tuning, overlay_.tuning_pair());
  if (preset.camera) session_.camera.put(*preset.camera, session_.show);
}

void WindowCommands::replace_models(const std::vector<std::string>& files) {
  const auto crowd = std::ranges::find_if(files, is_crowd_file);
  if (crowd != files.end() && files.size() == 1) return open_crowd(*crowd);
  if (crowd != files.end()) {
    return messages().say(*crowd + ": a crowd file says who is there; drop it alone", Message::Kind::refused);
  }
  if (tracks_.takes(files, session_)) return;
  if (messages().tell(session_.show.replace_models(files))) session_.reporter.describe_characters(session_.show);
}

void WindowCommands::copy_command_line() {
  const std::string cast = cast_options(session_.show.stage().people());
  copy(cast + (cast.empty() ? "" : " ") + command_line(session_.tuning, Tuning(), session_.camera.place()));
}

void WindowCommands::copy(const std::string& options) {
  session_.input.clipboard().set(options);
  static_cast<void>(print(options + "\n"));  // a window may have nobody who reads it
  messages().say("Copied: " + options);
}

void WindowCommands::say_where(const anim::Result<std::filesystem::path>& written) {
  if (written) {
    messages().say("Wrote " + written->string());
  } else {
    messages().say(written.error().message, Message::Kind::refused);
  }
}

void WindowCommands::take_screenshot() {
  const std::string file = unused_file(".png", screenshots_);
  Painter& painter = session_.show.painter();
  messages().tell(render::write_png(painter.renderer().read_image(), file, origin_texts(painter.drawn_by())),
                  "Wrote " + file);
}

}  // namespace throng::app
