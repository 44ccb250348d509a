// One frame of a show: the camera goes its way, the crowd is posed, then drawn.
#include <algorithm>
#include <chrono>

#include "app/show/show.h"
#include "app/view/camera_path.h"
#include "engine/render/mesh/mesh_lod.h"

namespace throng::app {
namespace {

double milliseconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

std::uint64_t Show::completed_frame() {
  if (renderer_ == nullptr) return stage_->frame();
  const std::uint64_t drawn = renderer_->fences().poll();
  return renderer_->fences().frames_in_flight() == 0 ? stage_->frame() : drawn;
}

void Show::film() {
  if (!films) return;
  if (path_ != CameraPath::none) {
    camera = along(path_, path_start_, anim::to_seconds(stage_->system().clock()));
  } else if (stage_->animated().cut_scene() != nullptr) {
    camera = stage_->animated().cut_scene()->film(camera);
  }
}

void Show::animate(anim::Ticks delta) { update(delta, nullptr); }

void Show::animate_as(const RecordedFrame& frame) {
  camera = frame.view.camera;
  films = false;
  update(frame.delta, &frame.view);
}

void Show::update(anim::Ticks delta, const LodView* as_recorded) {
  const anim::Ticks step = stage_->tuning().taken_away.animation ? 0 : delta;
  LodView view;
  const std::uint64_t completed = completed_frame();
  const bool had_memory = !stage_->shown().out_of_memory();
  const auto start = TimelineLog::Clock::now();
  update_ms_ = milliseconds_of([&] {
    stage_->move(step);
    film();
    freeze_lod_camera();
    view = as_recorded != nullptr ? *as_recorded : LodView{lod_camera(), width, height};
    stage_->pose(view.camera, view.width, view.height, step, completed);
  });
  times_.animation_ms = update_ms_;
  if (recorder_)
    recorder_->add({step, view, stage_->system().figures().pose_hash()}, stage_->system().figures().agent_hashes());
  if (keeps_moments_ && !stage_->tuning().paused) rewind_.watch(*stage_);
  if (had_memory && stage_->shown().out_of_memory()) update_notice();
  if (timeline_) timeline_->add_update(stage_->system(), start);
  statistics_.add_update(update_ms_);
  statistics_.add_report(*stage_);
}

int Show::pick_mesh_lod(std::uint8_t character, float pixels_tall, int at_least) const {
  const render::CrowdMesh& mesh = renderer_->meshes()[character];
  const int fixed = stage_->tuning().mesh_lod;
  if (fixed < 0) return render::pick_mesh_lod(mesh.triangles_by_lod(), pixels_tall, at_least, mesh_detail_);
  return std::min(fixed, static_cast<int>(mesh.lod_count()) - 1);
}

render::CrowdFrame Show::crowd_frame(const Picture& picture) const {
  return {.camera = render::view_of(camera, static_cast<float>(width) / static_cast<float>(height)),
          .instances = picture.instances(),
          .batches = picture.batches(),
          .now = stage_->now(),
          .bones_as_lines = stage_->tuning().bones_as_lines,
          .fill_pixels = !stage_->tuning().taken_away.pixels,
          .lines = lines_};
}

void Show::draw() {
  const auto start = TimelineLog::Clock::now();
  const TakenAway& taken_away = stage_->tuning().taken_away;
  times_.upload_ms = taken_away.upload ? 0.0 : milliseconds_of([&] {
    picture_.compose(*stage_, [this](std::uint8_t character, float pixels, int at_least) {
      return pick_mesh_lod(character, pixels, at_least);
    });
    gather_lines();
    if (splits()) {
      compose_exact();
    } else {
      renderer_->upload(crowd_frame(picture_));
    }
  });
  times_.submission_ms = taken_away.drawing ? 0.0 : milliseconds_of([&] {
    draw_counts_ = draw_pictures();
    renderer_->fences().insert(stage_->frame());
  });
  times_.wait_ms = milliseconds_of([&] { renderer_->finish(); });
  draw_ms_ = times_.upload_ms + times_.submission_ms + times_.wait_ms;
  if (timeline_) timeline_->add_part("draw", start, TimelineLog::Clock::now());
  statistics_.set_draw(draw_counts_.draw_calls, draw_counts_.triangles);
  statistics_.add_drawn_frame(update_ms_ + draw_ms_);
}

DrawnBy Show::drawn_by() const {
  if (context_ == nullptr) return {};
  return {.context = context_->kind(), .gl_version = context_->version(), .gl_renderer = context_->renderer()};
}

}  // namespace throng::app
