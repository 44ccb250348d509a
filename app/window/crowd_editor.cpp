#include "app/window/crowd_editor.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "app/people/crowd/crowd.h"
#include "app/show/beginning.h"
#include "app/show/painter.h"
#include "app/show/recording/recorder.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "app/window/frame_reporter.h"
#include "engine/base/text/joined.h"
#include "engine/tracks/read.h"
#include "engine/tracks/trajectories.h"

namespace throng::app {
namespace {

bool differ_in_pause_alone(const Tuning& tuning, Tuning other) {
  other.paused = tuning.paused;
  return tuning == other;
}

bool is_step(const CrowdRequest& request, const CrowdRequest& answer) {
  const auto* const values = std::get_if<Apply>(&request);
  return values == nullptr || !differ_in_pause_alone(values->tuning, std::get<Apply>(answer).tuning);
}

/// Returns the one part of the body for which two lists name different bones; nothing where they do for several.
std::optional<anim::BodyRole> changed_part(const std::vector<RigChoice>& before, const std::vector<RigChoice>& after) {
  std::optional<anim::BodyRole> changed;
  for (std::size_t i = 0; i < anim::body_role_count; ++i) {
    const auto part = static_cast<anim::BodyRole>(i);
    const auto bone = [part](const std::vector<RigChoice>& choices) {
      const auto found = std::ranges::find(choices, part, &RigChoice::role);
      return found == choices.end() ? std::string() : found->bone;
    };
    if (bone(before) == bone(after)) continue;
    if (changed) return {};
    changed = part;
  }
  return changed;
}

}  // namespace

CrowdEditor::CrowdEditor(Show& show, FrameReporter& reporter)
    : show_(show), reporter_(reporter), tuning_(show.stage().tuning()) {}

void CrowdEditor::follow() { tuning_ = show_.stage().tuning(); }

bool CrowdEditor::take(const CrowdRequest& request, const std::string& file) {
  const auto answer = answer_to(request, show_.stage(), tuning_);
  if (!make(request, file)) return false;
  if (!answer || !is_step(request, *answer)) return true;
  history_.add(as_made(request, show_.stage()), *answer, change_);
  return true;
}

Result<LoadPlan> CrowdEditor::plan_to_open(const CrowdSetup& setup) const {
  const TrajectoryOptions& asked = setup.trajectories;
  const bool lacks_tracks = setup.preset.tuning.scene == Scene::tracks && show_.stage().trajectories() == nullptr;
  if (asked.file.empty() && lacks_tracks) return Error{"it does not name its recorded crowd; drop that file first"};
  if (asked.file == "-") return Error{"its rows come from standard input; start the program with the file"};
  if (!asked.file.empty() && show_.recorder().is_recording()) return Error{no_recording_of_tracks};
  const CrowdRequest cast = SetCast{setup.characters};
  LoadPlan plan = show_.plan_for({&cast, 1});
  plan.tracks = asked.file;
  plan.reading = asked.reading;
  return plan;
}

bool CrowdEditor::open(const CrowdSetup& setup, const std::string& file, const ShownTracks& tracks) {
  if (tracks != nullptr) {
    if (const auto clock = first_clock(*tracks, setup.trajectories, true); !clock)
      return refuse(file, clock.error().message);
  }
  if (!take(SetCast{setup.characters}, file)) return false;
  if (tracks != nullptr && !take(tracks)) return false;
  const Tuning before = tuning_;
  Tuning tuning = setup.preset.tuning;
  tuning.inspection = with_kept_values(tuning_.inspection, tuning.inspection);
  if (!take(Apply{tuning}, file)) return false;
  if (tracks == nullptr) forget_tracks(before);
  DemoOptions options;
  begin_with(setup, options);
  const bool is_in_window = show_.painter().draws() && show_.painter().context().window() != nullptr;
  options.context = is_in_window ? ContextKind::window : ContextKind::headless_default;
  const Status begun = show_.begin_as(options);
  reporter_.describe_characters(show_);
  if (!begun) refuse(file, begun.error().message);
  return true;
}

bool CrowdEditor::refuse(const std::string& file, const std::string& why) {
  reporter_.messages().say(file + ": " + why, Message::Kind::refused);
  return false;
}

bool CrowdEditor::make(const CrowdRequest& request, const std::string& file) {
  const Status made = show_.take(request);
  if (!made) return say_why_not(request, (file.empty() ? "" : file + ": ") + made.error().message), false;
  if (std::holds_alternative<Apply>(request)) follow();
  if (brings_characters(request)) reporter_.describe_characters(show_);
  say_what_came_of(request);
  return true;
}

void CrowdEditor::say_what_came_of(const CrowdRequest& request) {
  const auto* const placement = std::get_if<SetPlacement>(&request);
  if (placement == nullptr) return;
  const CharacterSource& placed = show_.stage().people()[placement->character];
  reporter_.messages().say(placed.name + ": " + placed.placement.reasons);
}

void CrowdEditor::say_why_not(const CrowdRequest& request, const std::string& why) {
  const auto* const body = std::get_if<SetBody>(&request);
  const bool is_known = body != nullptr && body->character < show_.stage().people().size();
  const auto part = is_known ? changed_part(show_.stage().people()[body->character].rig, body->parts) : std::nullopt;
  if (part) return reporter_.refuse_body(*part, why);  // which stands in the part's row
  reporter_.messages().say(why, Message::Kind::refused);
}

bool CrowdEditor::make_all(const std::vector<CrowdRequest>& requests) {
  return std::ranges::all_of(requests, [this](CrowdRequest request) {
    if (auto* const values = std::get_if<Apply>(&request)) values->tuning.paused = tuning_.paused;
    return make(request);
  });
}

bool CrowdEditor::show_tracks(const ShownTracks& tracks) {
  if (tracks == nullptr) return true;
  if (!reporter_.messages().report(show_.replace_trajectories(tracks))) return false;
  follow();
  reporter_.describe_characters(show_);
  return true;
}

bool CrowdEditor::take(const ShownTracks& tracks) {
  const Stage& stage = show_.stage();
  RequestHistory::Step step{
      .change = change_++, .back = {Apply{tuning_}}, .tracks_back = stage.trajectories(), .tracks_forth = tracks};
  if (stage.crowd().tracks() != nullptr) step.back.emplace_back(Seek{stage.crowd().tracks()->clock()});
  if (!show_tracks(tracks)) return false;
  step.forth = {Apply{tuning_}};
  const bool comes_back = step.tracks_back == nullptr || !step.tracks_back->is_live;
  if (comes_back) history_.add(std::move(step));
  return true;
}

void CrowdEditor::forget_tracks(const Tuning& before) {
  const Stage& stage = show_.stage();
  const ShownTracks forgotten = stage.trajectories();
  if (forgotten == nullptr || forgotten->is_live) return;
  RequestHistory::Step step{.change = change_++, .forth = {Apply{tuning_}}, .tracks_back = forgotten};
  if (stage.track_clock()) step.back.emplace_back(Seek{*stage.track_clock()});
  step.back.emplace_back(Apply{before});
  if (show_.replace_trajectories(nullptr)) history_.add(std::move(step));
}

void CrowdEditor::undo() {
  const RequestHistory::Step* const step = history_.last();
  if (step == nullptr) return reporter_.messages().say("There is nothing to take back.");
  if (show_tracks(step->tracks_back) && make_all(step->back)) history_.took_back();
}

void CrowdEditor::redo() {
  const RequestHistory::Step* const step = history_.next();
  if (step == nullptr) return reporter_.messages().say("There is nothing to make again.");
  if (show_tracks(step->tracks_forth) && make_all(step->forth)) history_.made_again();
}

LoadPlan CrowdEditor::plan_to_undo() const {
  return history_.last() != nullptr ? show_.plan_for(history_.last()->back) : LoadPlan();
}

LoadPlan CrowdEditor::plan_to_redo() const {
  return history_.next() != nullptr ? show_.plan_for(history_.next()->forth) : LoadPlan();
}

bool CrowdEditor::can_undo_bones() const {
  return history_.last() != nullptr && std::holds_alternative<SetBones>(history_.last()->forth.back());
}

}  // namespace throng::app
