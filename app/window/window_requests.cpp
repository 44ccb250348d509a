#include "app/window/window_requests.h"

#include <algorithm>
#include <utility>

#include "app/files/whole_path.h"
#include "app/show/painter.h"
#include "app/show/recording/recorder.h"
#include "app/show/request/crowd_command.h"
#include "app/show/request/crowd_file.h"
#include "app/show/request/lent_clips.h"
#include "app/show/request/openable_files.h"
#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"
#include "app/show/viewer/viewer.h"
#include "app/window/drawn_overlay.h"
#include "app/window/still_picture.h"
#include "app/window/viewer_requests.h"
#include "app/window/wardrobe_requests.h"
#include "engine/base/files/output_file.h"

namespace throng::app {
namespace {

// "throng-1.png", in the working folder.
std::string unused_file(const char* ending, int& number) {
  std::string file;
  do file = "throng-" + std::to_string(++number) + ending;
  while (std::filesystem::exists(file));
  return file;
}

/// Returns the crowd that a request opens in place of the one that is shown; nothing where it opens none.
std::optional<std::string> opened_crowd(const Request& request) {
  if (const auto* const crowd = as<OpenCrowd>(request)) return crowd->crowd + crowd_file_ending;
  const auto* const asked = as<OpenFiles>(request);
  if (asked == nullptr) return std::nullopt;
  const auto crowd = std::ranges::find_if(asked->files, is_crowd);
  return crowd == asked->files.end() ? std::nullopt : std::optional(*crowd);
}

}  // namespace

void WindowRequests::take(const Requests& requests) {
  const bool changes_places = overlay_.tuning_pair().shows_b() != shows_b_;
  shows_b_ = overlay_.tuning_pair().shows_b();
  session_.loading.finish();
  video_.go_on(session_);
  for (const Request& request : requests) {
    const auto* const values = as<Apply>(request);
    if (values != nullptr && changes_places) {
      Tuning other = values->tuning;
      if (other.holds_rate) set_cost(other, cost_of(session_.editor.tuning()));
      session_.editor.take_in_passing(other);  // B takes that back by itself
    } else if (as<Quit>(request) != nullptr || opened_crowd(request)) {
      leaving_ = request;
    } else {
      take_at_once(request);
    }
  }
  go_on_leaving();
  report_jobs();
  if (session_.show.viewer() != nullptr) session_.sweep.stop();  // a crowd that waits costs nothing
  if (!overlay_.is_in_a_change()) session_.editor.end_change();
}

void WindowRequests::report_jobs() {
  std::vector<JobReport>& jobs = session_.reporter.report().jobs;
  jobs.clear();
  for (const auto& job : {session_.loading.report(), video_.report()}) {
    if (job) jobs.push_back(*job);
  }
}

void WindowRequests::take_at_once(const Request& request) {
  std::visit([this](const auto& part) { take(part); }, request);
}

void WindowRequests::go_on_leaving() {
  if (!leaving_) return;
  auto parts = session_.unsaved.parts(session_.editor.tuning(), overlay_.tuning_pair(), session_.crowd_work());
  if (parts.empty()) return carry_out(LeaveUnsaved{});
  session_.reporter.report().unsaved = {.parts = std::move(parts), .next = opened_crowd(*leaving_).value_or("")};
}

void WindowRequests::carry_out(const LeaveUnsaved& /*asked*/) {
  if (leaving_) take_at_once(*leaving_);
  carry_out(KeepWorking{});
}

void WindowRequests::carry_out(const KeepWorking& /*asked*/) {
  leaving_.reset();
  session_.reporter.report().unsaved.reset();
}

void WindowRequests::take_after_drawing(const Requests& requests) {
  if (!still_.empty()) draw_still();
  if (last_of<TakeStill>(requests) != nullptr) announce_still();
  if (last_of<TakeScreenshot>(requests) != nullptr) take_screenshot();
}

void WindowRequests::take(const CrowdRequest& request) {
  session_.loading.begin(session_.show.plan_for({&request, 1}), [this, request](const ShownTracks&) { make(request); });
}

bool WindowRequests::make(const CrowdRequest& request) {
  if (const auto* const values = std::get_if<Apply>(&request)) {
    return session_.editor.take(Apply{session_.rate.changed(values->tuning, session_.editor.tuning())});
  }
  if (!session_.editor.take(request)) return false;
  if (brings_characters(request)) session_.unsaved.keep(session_.crowd_work().characters);
  return true;
}

void WindowRequests::take(const WindowRequest& request) {
  std::visit([this](const auto& asked) { carry_out(asked); }, request);
}

void WindowRequests::take(const CameraRequest& request) {
  session_.camera.take(request, session_.show);
  const auto* const kept = std::get_if<KeepBookmark>(&request);
  if (kept == nullptr) return;
  const std::string key = std::to_string(kept->place + 1);
  messages().say("Kept this place of the camera as " + key + ". Key " + key + " goes there.");
}

void WindowRequests::take(const ViewerRequest& request) {
  const bool applies = std::holds_alternative<ApplyPreview>(request);
  const auto roles = applies ? previewed_roles(session_.show) : std::nullopt;
  messages().report(app::take(request, session_.show));
  if (roles) session_.editor.take(*roles);
}

void WindowRequests::carry_out(const SelectAt& asked) {
  const ShowView& view = session_.show.view();
  const glm::vec2 drawn(static_cast<float>(view.width), static_cast<float>(view.height));
  const glm::vec2 at =
      glm::vec2(asked.point.x, asked.point.y) * drawn / glm::vec2(session_.show.painter().renderer().size());
  session_.editor.take(Select{session_.show.agent_at(at.x, at.y)});
}

void WindowRequests::carry_out(const OpenFiles& asked) {
  const std::vector<std::string>& files = asked.files;
  const auto crowd = std::ranges::find_if(files, is_crowd_file);
  if (crowd != files.end() && files.size() == 1) return files_.open_crowd(*crowd);
  if (crowd != files.end()) {
    return messages().say(*crowd + ": a crowd file says who is there; drop it alone", Message::Kind::refused);
  }
  if (!open_tracks(files, session_)) open_models(files);
}

void WindowRequests::open_models(const std::vector<std::string>& files) {
  const auto lent = lent_clips(files, session_.show.stage().people());
  if (!lent) return messages().say(lent.error().message, Message::Kind::refused);
  const CrowdRequest request = *lent ? CrowdRequest((*lent)->request) : CrowdRequest(LoadModels{files});
  const std::string words = *lent ? (*lent)->words : std::string();
  session_.loading.begin(session_.show.plan_for({&request, 1}), [this, request, words, files](const ShownTracks&) {
    // Lent clips come to people who may hold unsaved work; models take the place of all of it.
    const bool is_made = words.empty() ? make(request) : session_.editor.take(request);
    if (!is_made) return;
    if (!words.empty()) messages().say(words);
    for (const std::string& file : files) session_.note_recent(file);
  });
}

// A change that is on its way is taken back by not making it.
void WindowRequests::carry_out(const Undo& /*asked*/) {
  if (session_.loading.goes_on()) return session_.loading.cancel();
  session_.loading.begin(session_.editor.plan_to_undo(), [this](const ShownTracks&) { session_.editor.undo(); });
}

void WindowRequests::carry_out(const Redo& /*asked*/) {
  session_.loading.begin(session_.editor.plan_to_redo(), [this](const ShownTracks&) { session_.editor.redo(); });
}

void WindowRequests::carry_out(const CancelJob& asked) {
  if (asked.job == SideJob::loading) session_.loading.cancel();
  if (asked.job == SideJob::video) video_.cancel();
}

void WindowRequests::carry_out(const ToggleRecording& /*asked*/) {
  Show& show = session_.show;
  const std::string file = session_.reporter.report().recording.file;
  if (show.recorder().is_recording())
    return static_cast<void>(messages().report(show.stop_recording(), "Wrote " + whole_path(file)));
  const std::string unused = unused_file(".rec", recordings_);
  if (!messages().report(show.start_recording(unused))) return;
  session_.reporter.report_recording(unused);
  messages().say("The crowd begins anew and is recorded; R writes " + whole_path(unused));
}

void WindowRequests::carry_out(const CopyCamera& /*asked*/) { copy(camera_option(session_.camera.place())); }

void WindowRequests::carry_out(const CopyCommandLine& /*asked*/) {
  copy(crowd_command(files_.described_here(), session_.show.stage().people()));
}

void WindowRequests::copy(const std::string& options) {
  session_.input.clipboard().set(options);
  static_cast<void>(print(options + "\n"));  // a window may have no reader of its output
  messages().say("Copied: " + options);
}

void WindowRequests::carry_out(const ReloadShaders& /*asked*/) {
  messages().report(session_.show.painter().renderer().reload_shaders(), "Built the shaders again");
}

void WindowRequests::carry_out(const ShowCharacter& asked) {
  session_.reporter.describe_character(session_.show, asked.character);
}

void WindowRequests::carry_out(const TuneRules& asked) { session_.editor.take(tuned(asked, session_.show.stage())); }

void WindowRequests::carry_out(const StartSweep& asked) {
  session_.sweep.start(asked.value, session_.editor.tuning(), session_.reporter.report().hardware_threads);
}

void WindowRequests::take_screenshot() {
  const std::string file = unused_file(".png", screenshots_);
  messages().report(write_picture(session_.show, file), "Wrote " + whole_path(file));
}

// It is drawn behind the next frame, in which the person reads that it takes its time.
void WindowRequests::announce_still() {
  still_ = unused_file(".png", screenshots_);
  messages().say("Drawing " + still_ + " in full quality");
}

void WindowRequests::draw_still() {
  const FrameReport& report = session_.reporter.report();
  const glm::ivec2 size = size_of_still(session_.show, report.output.picture_times);
  const std::string file = std::exchange(still_, {});
  DemoOptions options = session_.options;
  options.ui = options.legend = false;
  options.ui_scale = session_.panel_scale() * static_cast<float>(report.output.picture_times);
  const auto draw_ids = [&options](Show& show) {
    return show.stage().tuning().ids ? DrawnOverlay(options).draw(show) : Done{};
  };
  messages().report(write_still(session_.show, file, size, session_.best_values(), report.replay.has_value(), draw_ids),
                    "Wrote " + whole_path(file) + ", " + std::to_string(size.x) + "x" + std::to_string(size.y));
  messages().report(session_.show.painter().renderer().prepare_overlay());  // with the letters of the window
}

void WindowRequests::carry_out(const MakeVideo& /*asked*/) {
  video_.begin(session_, files_.described_here(), unused_file(".mp4", videos_));
}

void WindowRequests::carry_out(const SetOutput& asked) { session_.reporter.report().output = asked.choices; }

}  // namespace throng::app
