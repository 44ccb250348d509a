#include "app/window/window_session.h"

#include <algorithm>

#include "app/files/exit_status.h"
#include "app/people/crowd/crowd.h"
#include "app/settings/user_settings.h"
#include "app/show/lod/tuned_view.h"
#include "app/show/painter.h"
#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"

namespace throng::app {
namespace {

Status give(const Tuning& tuning, Show& show) {
  return tuning == show.stage().tuning() ? Done{} : show.take(Apply{tuning});
}

SetByHand set_by_hand(const DemoOptions& options) {
  const std::vector<std::string>& keys = options.values_given.keys;
  const auto is_given = [&](const char* key) { return std::ranges::find(keys, key) != keys.end(); };
  return {.picture_size = is_given("picture_size"),
          .triangle_budget = is_given("triangle_budget"),
          .shadows = is_given("shadows"),
          .crowd_shade = is_given("crowd_shade")};
}

}  // namespace

WindowSession::WindowSession(Show& show_in_window, const DemoOptions& given)
    : show(show_in_window),
      options(given),
      unsaved(show.stage().tuning()),
      input(show.painter().context().window()),
      camera(show),
      reporter(show),
      editor(show, reporter),
      loading(show, reporter.messages()),
      rate(set_by_hand(given), show.painter().is_on_software()),
      first_quality(quality_of(editor.tuning())) {
  if (options.no_settings) return;
  const auto settings = read_user_settings(user_settings_file());
  if (!settings) return;
  reporter.report().recent_files = settings->recent_files;
  reporter.report().output = settings->output;
  first_panel_width = settings->panel_width;
}

float WindowSession::panel_scale() const {
  const bool is_asked_for = std::ranges::find(options.given, "--ui-scale") != options.given.end();
  return is_asked_for ? options.ui_scale : input.content_scale();
}

Tuning WindowSession::best_values() const {
  Tuning best = rate.at_best(editor.tuning());
  const DeviceChoices& device = show.painter().device_choices();
  if (device.error_px == 0.0F) return best;
  const Tuning usual;
  if (best.error_px == device.error_px) best.error_px = usual.error_px;
  if (best.mesh_error_px == device.error_px * mesh_share_of_error) best.mesh_error_px = usual.mesh_error_px;
  return best;
}

void WindowSession::show_wanted_values(bool exact_crowd) {
  const Tuning& tuning = editor.tuning();
  if (!sweep.began_with(tuning)) sweep.stop();
  while (sweep.runs() && !exact_crowd) {
    const Status given = give(sweep.tuning(), show);
    if (given) return;
    sweep.refuse(given.error().message);
  }
  messages().report(give(exact_crowd ? without_level_of_detail(tuning) : shown_values(), show));
}

// Another window may have left its own settings since this one started.
void WindowSession::keep_settings(glm::ivec2 window_size, int panel_width) const {
  const std::filesystem::path file = user_settings_file();
  if (options.no_settings || file.empty()) return;
  const auto read = read_user_settings(file);
  UserSettings settings = read ? *read : UserSettings();
  const UserSettings before = settings;
  const std::string_view quality = quality_of(editor.tuning());
  if (!quality.empty() && quality != first_quality) settings.quality = quality;
  if (window_size != glm::ivec2(options.width, options.height)) {
    settings.width = window_size.x;
    settings.height = window_size.y;
  }
  if (panel_width != first_panel_width) settings.panel_width = panel_width;
  settings.recent_files = reporter.report().recent_files;
  settings.output = reporter.report().output;
  if (settings == before) return;
  if (const Status kept = write_user_settings(file, settings); !kept) end_with(exit_done, kept.error().message);
}

CrowdWork WindowSession::crowd_work() const {
  const Stage& stage = show.stage();
  CrowdWork work{.places = camera.bookmarks()};
  for (const CharacterSource& person : stage.people()) work.characters.push_back(chosen(person));
  if (stage.tuning().scene != Scene::tracks || stage.trajectories()->is_live) return work;
  const bool moves_by_itself = show.view().films || show.view().guide.follows();
  work.recorded = {.clock = stage.crowd().tracks()->clock(), .camera = {}};
  if (!moves_by_itself) work.recorded->camera = camera.place();
  return work;
}

void WindowSession::note_recent(const std::filesystem::path& file) {
  constexpr std::size_t most = 10;
  std::error_code ignored;
  const std::string name = std::filesystem::absolute(file, ignored).lexically_normal().string();
  std::vector<std::string>& recent = reporter.report().recent_files;
  std::erase(recent, name);
  recent.insert(recent.begin(), name);
  recent.resize(std::min(recent.size(), most));
}

// Frames in which no agent was posed, or the exact crowd was, tell nothing.
void WindowSession::measure_for_sweep() {
  const Stage& stage = show.stage();
  const bool tells = sweep.runs() && stage.tuning() == sweep.tuning();
  if (tells && stage.system().figures().report().agents_updated > 0) sweep.add(cost_of_last_update(stage.system()));
  reporter.report().sweep = sweep.curve();
}

}  // namespace throng::app
