#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iterator>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "engine/anim/asset/keyframe_stream_clip.h"
#include "engine/anim/asset/model_check.h"
#include "engine/anim/asset/morph_limits.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/bake/clip_in_place.h"
#include "engine/anim/bake/footsteps.h"
#include "engine/anim/bake/grid.h"
#include "engine/anim/bake/ground_speed.h"
#include "engine/anim/bake/name_numbers.h"
#include "engine/anim/bake/parallel.h"
#include "engine/anim/bake/reorder.h"
#include "engine/anim/bake/root_motion.h"
#include "engine/anim/bake/sampled.h"
#include "engine/anim/bake/still_tracks.h"
#include "engine/anim/bake/surface.h"
#include "engine/anim/base/misuse.h"
#include "engine/anim/survey/entry_boxes.h"

namespace throng::anim {

namespace {

// These limits are meant for a person of 1.8 m and scale with the character.
constexpr double surface_error = 0.0002;  // metres: the bound of sampled streams
constexpr double still_share = 0.2;       // of the bound: for tracks that hardly move
constexpr double hopeless_step = 4.0;     // times the bound: no sampled stream comes near to such a step
constexpr double closing_error = 0.005;   // metres between the first and the last pose of a loop
constexpr double gait_gap = 0.1;          // metres: a gait whose last pose is farther off was never meant to repeat
constexpr double least_way = 1.0;         // metres: a clip that goes so far walks, even if it does not repeat

void add_note(BakedClip& baked, const std::string& note) { baked.note += (baked.note.empty() ? "" : "; ") + note; }

/// Returns the times at which STEP tracks jump.
std::vector<Ticks> step_times(const StateClip& clip) {
  std::vector<Ticks> times;
  for (const StateTrack& track : clip.tracks) {
    if (track.interpolation != Interpolation::step) continue;
    for (std::size_t key = 1; key < track.keys.size(); ++key) times.push_back(track.keys[key].time);
  }
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// Compares poses of one clip on the surface.
class PoseDistance {
 public:
  explicit PoseDistance(const SampleSource& source) : source_(source), poses_(source.exact) {}
  double between(Ticks a, Ticks b) {
    const std::vector<BoneFrame> first = frames(a);
    return largest_distance(source_.proxy, first, frames(b));
  }

 private:
  std::vector<BoneFrame> frames(Ticks time) {
    std::vector<BoneFrame> result(source_.skeleton.bones.size());
    compute_frames(source_.skeleton, poses_.at(time), result);
    return result;
  }
  const SampleSource& source_;
  ExactPoses poses_;
};

/// Finds out whether a clip loops. A clip whose last key stands one step before its first looks like a loop, but would
/// hitch at the seam, so a note says that it does not loop. `grid` is given for clips that move smoothly. Returns
/// whether the clip repeats one movement, with or without a hitch at its seam.
bool find_loop(BakedClip& baked, const SampleSource& source, const std::optional<KeyGrid>& grid) {
  if (baked.duration == Ticks{}) return false;
  const double size = source.proxy.height / tall_person;
  PoseDistance distance(source);
  const double gap = distance.between(Ticks{}, baked.duration);
  baked.loops = gap <= closing_error * size;
  if (baked.loops || !grid || grid->step() > baked.duration) return gap <= gait_gap * size;
  const double first_step = distance.between(Ticks{}, grid->step());
  const double last_step = distance.between(baked.duration - grid->step(), baked.duration);
  const bool hitches = gap < 1.5 * std::max(first_step, last_step);
  if (hitches) {
    baked.closing_step = grid->step();
    add_note(baked, "does not loop: its last key stands one step before its first");
  }
  return hitches || gap <= gait_gap * size;
}

/// Returns BakedClip::ground_velocity. `repeats` is what find_loop() returned.
glm::dvec2 ground_velocity_of(const BakedClip& baked, const SampleSource& source, bool repeats) {
  constexpr glm::dvec2 none(0.0);
  if (baked.duration == Ticks{}) return none;
  if (baked.root_motion.keys.empty()) {
    return repeats ? -stance_velocity(sample_stride(source.skeleton, baked, source.proxy.height)) : none;
  }
  const bool goes_far = glm::length(baked.loop_displacement) >= least_way * source.proxy.height / tall_person;
  return repeats || goes_far ? travel_velocity(baked.root_motion) : none;
}

std::string in_millimetres(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g mm", 1000.0 * metres);
  return text;
}

/// Says why a clip plays from its keyframe stream, or gives it a sampled stream that keeps to the bound.
void bake_sampled_stream(BakedClip& baked, const SampleSource& source, const StateClip& clip,
                         const std::optional<KeyGrid>& grid, Ticks last_key) {
  const auto play_from_keys = [&](const std::string& why) {
    add_note(baked, "plays from its keyframe stream: " + why);
  };
  const double step = source.steps.empty() ? 0.0 : largest_step(source.skeleton, source.proxy, clip);
  if (step > hopeless_step * source.error_bound)
    return play_from_keys("a STEP track moves it by " + in_millimetres(step));
  if (!clip.tracks.empty() && !grid) return play_from_keys("its keys lie on no grid of up to 120 Hz");
  SampledBake bake = clip.tracks.empty() ? bake_still(source) : bake_sampled(source, *grid, last_key);
  if (!bake.block && std::isinf(bake.error)) return play_from_keys("it is too long, or turns too fast, to be sampled");
  if (!bake.block)
    return play_from_keys("sampled at up to 240 Hz it would be at least " + in_millimetres(bake.error) + " off");
  baked.sampled_block = std::move(bake.block);
  baked.sampled_rate = bake.rate;
  baked.sampled_rounding = bake.rounding;
  baked.sampled_error = baked.keyframe_error + bake.error;
}

double start_of(const Clip& clip, const BakeOptions& options) { return options.as_in_the_file ? 0.0 : clip.start; }

BakedClip bake_clip(const Skeleton& skeleton, const SurfaceProxy& proxy, const Clip& clip, const BakeOptions& options) {
  const double size = proxy.height / tall_person;
  const double start = start_of(clip, options);
  ClipInPlace placed = put_in_place(skeleton, proxy, clip,
                                    {.start = start,
                                     .take_root_motion = options.take_root_motion,
                                     .still = options.as_in_the_file ? 0.0 : still_share * surface_error * size});
  const StateClip& state = placed.state;
  BakedClip baked;
  baked.morphs = bake_morph_curves(clip, start);
  baked.name = clip.name;
  baked.duration = state.duration;
  baked.error_bound = surface_error * size;
  baked.keyframe_error = placed.error;
  const std::vector<Ticks>& keys = placed.keys;
  const std::vector<Ticks> steps = step_times(state);
  const std::optional<KeyGrid> grid = keys.empty() ? std::nullopt : find_grid(keys, state.start);
  baked.root_motion = std::move(placed.root_motion);
  baked.loop_displacement = whole_motion(baked.root_motion).translation;
  baked.keyframe_block = pack_keyframe_stream(state);

  const glm::dvec3 travel = straight_travel(baked.root_motion);
  const SampleSource source{skeleton, proxy, *baked.keyframe(), travel, baked.error_bound - baked.keyframe_error,
                            steps};
  const bool repeats = find_loop(baked, source, steps.empty() ? grid : std::nullopt);
  baked.ground_velocity = ground_velocity_of(baked, source, repeats);
  bake_sampled_stream(baked, source, state, grid, keys.empty() ? Ticks{} : keys.back());
  return baked;
}

/// Returns how far the poses of a baked clip reach.
double reach_of(const BoundsSurvey& room, const Skeleton& skeleton, const SurfaceProxy& proxy, const Clip& clip,
                const BakedClip& baked, double start) {
  if (!turns(baked.root_motion)) return room.reach(clip, baked.loop_displacement);
  return room.reach(without_turn(skeleton, proxy, clip, baked.root_motion, start), glm::dvec3(0.0));
}

/// Returns the file's data keys in the time of the baked clip, or footsteps for a loop that has none.
std::vector<NamedDataKey> data_keys_of(const Character& character, const Clip& clip, const BakedClip& baked,
                                       const BakeOptions& options) {
  if (clip.data_keys.empty() && baked.loops) {
    return find_footsteps(character.skeleton, baked, character.height);
  }
  std::vector<NamedDataKey> keys = clip.data_keys;
  for (NamedDataKey& key : keys) key.time -= options.as_in_the_file ? 0.0 : clip.start;
  return keys;
}

/// Data keys get the numbers of their names one clip after the other, so that no thread decides them.
void add_data_keys(NameNumbers& names, BakedClip& baked, std::span<const NamedDataKey> keys) {
  for (const NamedDataKey& key : keys) {
    const Ticks time = std::clamp(key_ticks(key.time), Ticks{}, baked.duration);
    baked.data_keys.push_back({.time = time, .name = names.of(key.name)});
  }
  std::ranges::stable_sort(baked.data_keys, {}, &DataKey::time);
}

/// Curves get the numbers of their names as data keys do.
void add_curves(NameNumbers& names, BakedClip& baked, const Clip& clip, double start) {
  for (const NamedCurve& curve : clip.curves) {
    baked.curves.push_back(bake_curve(curve, start, names.of(curve.name)));
  }
}

}  // namespace

Character bake_character(const Model& model, const BakeOptions& options) {
  if (const Status valid = check_model(model); !valid) {
    report_misuse({"bake_character", valid.error().message.c_str()});
    return {};
  }
  static const std::vector<Clip> rest{{.name = "rest", .tracks = {}}};
  const std::vector<Clip>& clips = model.clips.empty() ? rest : model.clips;
  const SurfaceProxy proxy = make_surface_proxy(model);
  Character character{.skeleton = model.skeleton,
                      .hierarchy = compile_hierarchy(model.skeleton),
                      .clips = std::vector<BakedClip>(clips.size()),
                      .height = proxy.height,
                      .skip_errors = std::vector<SkipError>(clips.size()),
                      .morph_bones = morph_bones(model),
                      .morph_reach = morph_reach(model),
                      .entry_boxes = entry_boxes(model),
                      .level_entries = entries_of_levels(model.skeleton)};
  const BoundsSurvey room(model);
  std::vector<double> reaches(clips.size());
  std::vector<std::vector<NamedDataKey>> data_keys(clips.size());
  std::mutex telling;
  std::size_t done = 0;
  const auto bake = [&](std::size_t clip) {
    BakedClip& baked = character.clips[clip];
    baked = bake_clip(character.skeleton, proxy, clips[clip], options);
    data_keys[clip] = data_keys_of(character, clips[clip], baked, options);
    reaches[clip] = reach_of(room, character.skeleton, proxy, clips[clip], baked, start_of(clips[clip], options));
    character.skip_errors[clip] = measure_skip_error(character.skeleton, proxy, baked, clips.size());
    if (!options.progress) return;
    const std::scoped_lock lock(telling);
    options.progress(++done, clips.size());
  };
  const std::function<void()> surveys[] = {[&] { character.bone_lod = measure_bone_lod(model); },
                                           [&] { character.surface_points = choose_surface_points(model); }};
  in_parallel(std::size(surveys) + clips.size(),
              [&](std::size_t part) { part < std::size(surveys) ? surveys[part]() : bake(part - std::size(surveys)); });
  character.bounds = room.bounds(reaches);
  character.bounds.reach += character.morph_reach;
  NameNumbers keys(character.data_key_names), curves(character.curve_names);
  for (std::size_t clip = 0; clip < clips.size(); ++clip) {
    add_data_keys(keys, character.clips[clip], data_keys[clip]);
    add_curves(curves, character.clips[clip], clips[clip], start_of(clips[clip], options));
  }
  return character;
}

}  // namespace throng::anim
