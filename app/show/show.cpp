#include "app/show/show.h"

#include <chrono>
#include <utility>

#include "app/show/beginning.h"
#include "app/show/load_plan.h"
#include "app/show/request_history.h"
#include "app/show/show_parts.h"
#include "app/show/show_requests.h"
#include "app/show/stage/picking.h"

namespace throng::app {

Show::Show(std::unique_ptr<ShowParts> parts) : parts_(std::move(parts)), notice_(notice_of(*parts_)) {}

Show::~Show() = default;

Status Show::take(const CrowdRequest& request) {
  Status taken = std::visit([this](const auto& asked) { return carry_out(asked, *parts_); }, request);
  if (!taken) return taken;
  if (parts_->recorder.is_recording()) parts_->recorder.add(as_made(request, *parts_->stage));
  notice_ = notice_of(*parts_);
  return taken;
}

Status Show::replace_characters(std::vector<CharacterSource> characters) {
  Status replaced = app::replace_characters(std::move(characters), *parts_);
  notice_ = notice_of(*parts_);
  return replaced;
}

LoadPlan Show::plan_for(std::span<const CrowdRequest> requests) const {
  LoadPlan plan{.options = parts_->models.options, .data = parts_->models.data, .is_drawn = parts_->painter->draws()};
  for (const CrowdRequest& request : requests) {
    if (auto cast = cast_to_load(request, parts_->stage->people())) plan.casts.push_back(std::move(*cast));
  }
  return plan;
}

void Show::take_ahead(std::deque<LoadedCast> casts) { parts_->models.ahead = std::move(casts); }

Status Show::replace_trajectories(std::shared_ptr<const Trajectories> trajectories) {
  Status replaced = app::replace_trajectories(std::move(trajectories), *parts_);
  notice_ = notice_of(*parts_);
  return replaced;
}

Status Show::begin_as(const DemoOptions& options) {
  StartError error;
  const bool begun = begin_tracks(*parts_->stage, options, error) && place_camera(*parts_, options, error);
  return begun ? Status(Done{}) : Error{error.message};
}

Status Show::open_viewer(const ViewRequest& request) { return app::open_viewer(request, *parts_); }

void Show::animate_as(const RecordedFrame& frame) {
  parts_->view.camera = frame.view.camera;
  parts_->view.films = false;
  update(frame.delta, &frame.view);
}

void Show::update(Ticks delta, const LodView* as_recorded) {
  if (parts_->viewer != nullptr) return parts_->viewer->advance(delta);
  Stage& stage = *parts_->stage;
  const Tuning& tuning = stage.tuning();
  const Ticks step = tuning.taken_away.animation ? Ticks{} : delta;
  parts_->painter->follow_outfits(stage);
  const std::uint64_t completed = parts_->painter->completed_frame(stage);
  const bool had_memory = !stage.posed().shown().out_of_memory();
  const auto start = RunFigures::Clock::now();
  if (parts_->live != nullptr) take_live_rows(step);
  stage.move(step);
  parts_->view.move(stage, tuning.inspection.freeze_camera);
  const LodView view = as_recorded != nullptr ? *as_recorded : parts_->view.for_level_of_detail();
  stage.pose(view.camera, view.width, view.height, step, completed);
  const double milliseconds = std::chrono::duration<double, std::milli>(RunFigures::Clock::now() - start).count();
  if (parts_->recorder.is_recording()) {
    parts_->recorder.add(RecordedFrame{step, view, stage.system().figures().pose_hash()},
                         stage.animated().agent_hashes());
  }
  // Any moment of a recorded crowd is there at once, and the moments of a live crowd cannot be found again.
  const bool has_clock_of_its_own = stage.crowd().tracks() != nullptr;
  if (parts_->keeps_moments && !tuning.paused && !has_clock_of_its_own) parts_->rewind.watch(stage);
  if (had_memory && stage.posed().shown().out_of_memory()) notice_ = notice_of(*parts_);
  parts_->figures.add_update(stage, start, milliseconds);
  parts_->past_stage = std::move(parts_->replaced_stage);  // the frame after ends it, since that takes a frame's time
}

void Show::take_live_rows(Ticks step) {
  parts_->stage->take_live_step(parts_->live->advance(to_seconds(step)));
  if (std::exchange(live_news_, parts_->live->news()) != live_news_) notice_ = notice_of(*parts_);
}

bool Show::has_rows_for(Ticks step, std::chrono::milliseconds most) {
  return parts_->live == nullptr || parts_->live->can_go_on(to_seconds(step), most);
}

Status Show::draw() {
  Painter& painter = *parts_->painter;
  const ShowView& seen = parts_->view;
  if (parts_->viewer == nullptr) {
    const std::size_t left_out_before = painter.lines_left_out();
    Status drawn = painter.draw(*parts_->stage, seen, parts_->figures);
    if (painter.lines_left_out() != left_out_before) notice_ = notice_of(*parts_);
    return drawn;
  }
  const render::Camera round = parts_->viewer->turntable().camera(seen.aspect(), 1.0F - seen.free.right);
  return painter.draw(parts_->viewer->frame(render::view_of(round, seen.aspect())), parts_->stage->tuning());
}

Status Show::draw_labels(bool is_drawn, render::LabelPicture& labels) {
  PaintedView seen = parts_->view;
  seen.frozen.reset();
  return parts_->painter->draw_labels(*parts_->stage, seen, is_drawn, labels);
}

Status Show::start_recording(const std::filesystem::path& file) {
  Stage& stage = *parts_->stage;
  if (stage.tuning().scene == Scene::tracks) return Error{no_recording_of_tracks};
  const RecordingHeader header{exactly(stage.people()), stage.tuning(), parts_->view.width, parts_->view.height};
  if (Status started = parts_->recorder.start(file, header); !started) return started;
  if (stage.posed().frame() > 0) stage.restart();
  parts_->rewind.forget();
  keep_moments();
  return Done{};
}

Status Show::begin_anew(const Tuning& tuning) {
  if (Status applied = take(Apply{tuning}); !applied) return applied;
  Stage& stage = *parts_->stage;
  stage.restart();
  parts_->rewind.forget();
  parts_->view.frozen.reset();
  if (stage.animated().event_sums()) stage.animated().sum_up_events();
  return Done{};
}

std::optional<std::uint32_t> Show::agent_at(float x, float y) const {
  const auto size = glm::vec2(glm::ivec2(view().width, view().height));
  const auto picked = pick(ray_through(view().camera, {x, y}, size), bodies_in_view(stage()));
  return picked ? std::optional(picked->agent) : std::nullopt;
}

void Show::keep_moments() { parts_->keeps_moments = true; }
const Rewind& Show::moments() const { return parts_->rewind; }
void Show::leave_viewer() { parts_->viewer.reset(); }
Viewer* Show::viewer() const { return parts_->viewer.get(); }
Status Show::stop_recording() { return parts_->recorder.stop(); }
const Recorder& Show::recorder() const { return parts_->recorder; }
const LiveCrowd* Show::live() const { return parts_->live.get(); }
const Stage& Show::stage() const { return *parts_->stage; }
Painter& Show::painter() { return *parts_->painter; }
const Painter& Show::painter() const { return *parts_->painter; }
RunFigures& Show::figures() { return parts_->figures; }
const RunFigures& Show::figures() const { return parts_->figures; }
ShowView& Show::view() { return parts_->view; }
const ShowView& Show::view() const { return parts_->view; }

}  // namespace throng::app
