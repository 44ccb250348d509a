#include "app/show/stage/posed_crowd.h"

#include <algorithm>
#include <vector>

#include "app/show/lod/tuned_view.h"
#include "engine/base/glm_numbers.h"

namespace throng::app {
namespace {

constexpr std::size_t agents_ahead = 12;  // that the caches are asked for while one is shown

float tallest_of(std::span<const CharacterSource> characters) {
  double height = 0.0;
  for (const CharacterSource& source : characters) height = std::max(height, source.character->bounds.height);
  return static_cast<float>(height);
}

// The view of errors colours all agents in view.
ErrorSampling error_sampling(const Tuning& tuning) {
  return tuning.debug_view == DebugView::error ? ErrorSampling::all : tuning.error_sample;
}

std::vector<ViewedCharacter> viewed_characters(std::span<const CharacterSource> characters) {
  std::vector<ViewedCharacter> viewed;
  for (const CharacterSource& source : characters) viewed.push_back(viewed_character(source));
  return viewed;
}

}  // namespace

/// The input that all steps of a frame read.
struct PosedCrowd::Frame {
  AnimatedCrowd& animated;
  const SeenFrame& seen;
  const Tuning& tuning;
  SystemFrame view;
  anim::AnimationSystem& system = animated.system();
};

PosedCrowd::PosedCrowd(std::span<const CharacterSource> characters, render::PalettePageSource& pages,
                       std::uint64_t first_frame)
    : SystemView(viewed_characters(characters), pages, first_frame), characters_(characters) {}

void PosedCrowd::pose(AnimatedCrowd& animated, const SeenFrame& seen, const Tuning& tuning, StageTimes& times) {
  StopWatch watch;
  const Frame frame{animated, seen, tuning, view_frame(animated, seen, tuning)};
  choose(frame.system, frame.view);
  times.selection_ms = watch.lap();

  const std::span<const anim::VisibleAgent> visible = selection().visible;
  const Crowd& crowd = std::as_const(animated).crowd();
  measures_.take(crowd, tuning, frame.system.executor(), frame.system.options().pus);
  joints_.make_room(crowd.size());
  prepare(frame, updates());
  if (tuning.lod.rule != LodRule::off) animated.details().take_back(visible);
  animated.details().hold_things(visible);
  add_fallen(frame);
  SystemView::pose(frame.system, frame.view);
  animated.let_fallen_get_up();
  times.pose_ms = watch.lap();
}

Camera PosedCrowd::seen_by(const SeenFrame& seen, const render::CameraView& view, const Tuning& tuning) const {
  Camera camera{.position = from_glm(seen.camera.position),
                .forward = from_glm(render::forward(seen.camera)),
                .pixels_per_unit = render::pixels_tall(seen.camera, seen.size.y, 1.0F, 1.0F)};
  std::ranges::transform(render::frustum_planes(view), camera.frustum.begin(), [](const glm::vec4& plane) {
    return std::array{plane.x, plane.y, plane.z, plane.w};
  });
  if (tuning.shadows && render::casts_shadows(tuning.light)) {
    include_casters(camera, from_glm(render::to_brightest(tuning.light)), tallest_of(characters_));
  }
  return camera;
}

SystemFrame PosedCrowd::view_frame(const AnimatedCrowd& animated, const SeenFrame& seen, const Tuning& tuning) const {
  const Crowd& crowd = animated.crowd();
  const render::CameraView view = render::view_of(seen.camera, seen.size.x / seen.size.y);
  return {.agents = placed_agents(crowd),
          .clips = crowd.minds().clips(),
          .left_out = animated.fallen().left_out(),
          .absent = absent_of(crowd),
          .rules = view_rules(tuning, seen.selected),
          .sampling = error_sampling(tuning),
          .camera = seen_by(seen, view, tuning),
          .view = view.view,
          .projection = view.projection,
          .size = seen.size,
          .step = seen.moves ? seen.step : Ticks{},
          .selected = seen.selected,
          .completed = seen.completed};
}

/// Sets the parts of poses beyond clips, and where palettes go.
void PosedCrowd::prepare(const Frame& frame, std::span<PoseRequest> updates) {
  BodyDetails& details = frame.animated.details();
  for (std::size_t i = 0; i < updates.size(); ++i) {
    if (i + agents_ahead < updates.size()) prefetch_pose(updates[i + agents_ahead].agent.number);
    PoseRequest& update = updates[i];
    const std::uint32_t agent = update.agent.number;
    const bool visible = level_of_detail().is_visible(agent);
    details.follow_track(updates.subspan(i));
    place_feet(frame, update, visible && update.look_ahead == Ticks{});
    if (!visible) continue;
    const bool is_of_now = show(frame.system, frame.view, update);
    update.joints = joints_.destination(agent);
    if (is_of_now) details.follow_track(updates.subspan(i, 1));
  }
}

// Feet are placed for agents that are evaluated each frame and not ahead, so that it is known where the feet are;
// without level of detail, for all.
void PosedCrowd::place_feet(const Frame& frame, const PoseRequest& update, bool near_by) const {
  const bool everyone = frame.tuning.lod.rule == LodRule::off;
  const anim::LodChoice choice = level_of_detail().choice(update.agent.number);
  const bool stand =
      frame.tuning.placed_feet && choice.bone_level == 0 && (everyone || (near_by && choice.interval == 1));
  frame.animated.details().place_feet(update.agent.number, stand, shown().pose(update.agent.number).shown());
}

// Rag-dolls have no pose that could be looked ahead to, and fall on out of view too.
void PosedCrowd::add_fallen(const Frame& frame) {
  for (const FallenAgents::Fallen& fallen : frame.animated.fallen().fallen()) {
    const ShownPose& pose = shown().pose(fallen.agent);
    const bool looked_ahead = pose.shown() && static_cast<std::int32_t>(pose.to_time - now()) > 0;
    if (looked_ahead || (!frame.seen.moves && pose.shown())) continue;
    PoseRequest& update = show_also(frame.system, frame.view, fallen.agent);
    if (level_of_detail().is_visible(fallen.agent)) update.joints = joints_.destination(fallen.agent);
  }
}

}  // namespace throng::app
