#include "app/window/frame_reporter.h"

#include <algorithm>

#include "app/output/label_frame.h"
#include "app/show/painter.h"
#include "app/show/recording/recorder.h"
#include "app/show/show.h"
#include "app/show/stage/rewind.h"
#include "app/show/stage/stage.h"
#include "app/show/viewer/viewer.h"
#include "app/window/character_reporter.h"
#include "app/window/selection_reporter.h"
#include "app/window/window_camera.h"
#include "engine/base/files/cores.h"

namespace throng::app {
namespace {

constexpr std::size_t history_frames = 240;

void remember(std::vector<float>& history, double milliseconds) {
  if (history.size() == history_frames) history.erase(history.begin());
  history.push_back(static_cast<float>(milliseconds));
}

int depth_of(const anim::Skeleton& skeleton, int bone) {
  int depth = 0;
  for (int parent = skeleton.bones[static_cast<std::size_t>(bone)].parent; parent >= 0;
       parent = skeleton.bones[static_cast<std::size_t>(parent)].parent) {
    ++depth;
  }
  return depth;
}

PlacementReport placement_of(const CharacterSource& source) {
  const anim::GuessedPlacement& guessed = source.placement;
  PlacementReport report{.choice = guessed.choice,
                         .scale = guessed.placement.scale,
                         .guessed_scale = guessed.placement.scale,
                         .units_tall = 0.0,
                         .reasons = guessed.reasons};
  if (!guessed.extent) return report;
  report.guessed_scale = anim::guessed_scale(*guessed.extent, anim::SizeRule::among_people);
  report.units_tall = guessed.extent->size.y;
  return report;
}

constexpr double most_spans_in_a_lane = 512;
constexpr std::size_t timeline_frames = 8;
constexpr std::size_t most_heads = 300;
constexpr float above_head = 0.12F;  // metres

// Tasks too short to be told apart in a lane become one span.
std::vector<anim::TraceSpan> joined_spans(const anim::Trace& trace, const anim::UpdateTime& time) {
  const auto shortest = static_cast<double>(time.last_tick - time.first_tick) / most_spans_in_a_lane;
  std::vector<anim::TraceSpan> spans;
  anim::JoinedContent content;  // of the last of them
  for (const anim::TraceSpan& span : trace.spans()) {
    if (span.kind > anim::TraceSpan::Kind::wait) continue;  // lanes do not show the kinds after it
    anim::TraceSpan* const last = spans.empty() ? nullptr : &spans.back();
    if (last == nullptr || last->kind != span.kind || static_cast<double>(span.end - last->begin) >= shortest) {
      spans.push_back(span);
      content = {};
    } else {
      last->end = span.end;
      last->bytes_in += span.bytes_in;
      last->bytes_out += span.bytes_out;
      last->transfers += span.transfers;
    }
    content.add(span.content);
    spans.back().content = content.all();
  }
  return spans;
}

void count(std::vector<int>& counts, std::size_t place) {
  if (counts.size() <= place) counts.resize(place + 1, 0);
  ++counts[place];
}

// Props have no feet and no bones to speak of, so people alone count.
Situation situation_of(const Stage& stage, int mesh_levels) {
  Situation situation{.selected = stage.selected().has_value(),
                      .places_feet = false,
                      .can_pack = false,
                      .has_wardrobe = false,
                      .bone_levels = 1,
                      .mesh_levels = mesh_levels,
                      .pus = stage.system().options().pus,
                      .has_tracks = stage.trajectories() != nullptr};
  for (std::size_t i = 0; i < stage.people().size(); ++i) {
    const CharacterSource& person = stage.people()[i];
    situation.places_feet |= stage.animated().rigs(i).foot_placement().has_value();
    situation.can_pack |= person.character->skeleton.rigid;
    situation.has_wardrobe |= !person.model.parts.empty() || !person.roles.bodies.empty();
    const auto levels = static_cast<int>(person.character->skeleton.level_bone_counts.size());
    situation.bone_levels = std::max(situation.bone_levels, levels);
  }
  return situation;
}

}  // namespace

FrameReporter::FrameReporter(const Show& show) {
  describe_device(show);
  describe_characters(show);
  add_tracks(show.stage());
}

void FrameReporter::describe_characters(const Show& show) {
  report_.characters.clear();
  report_.cast.clear();
  mesh_levels_ = 1;
  for (std::size_t i = 0; i < show.stage().people().size(); ++i) {
    mesh_levels_ = std::max(mesh_levels_, static_cast<int>(show.painter().mesh_levels(i).size()));
  }
  for (const CharacterSource& character : show.stage().people()) {
    report_.characters.push_back(character.name);
    report_.cast.push_back({.share = character.roles.share, .starting_share = character.roles.share});
  }
  const std::span<const CharacterSource> people = show.stage().people();
  report_.has_built_in_cast = people.size() == 1 && people.front().file.empty();
  describe_character(show, 0);
}

void FrameReporter::describe_device(const Show& show) {
  const DrawnBy drawn_by = show.painter().drawn_by();
  report_.context = drawn_by.context;
  report_.gl_version = drawn_by.gl_version;
  report_.gl_renderer = drawn_by.gl_renderer;
  report_.hardware_threads = usable_cores();
}

void FrameReporter::describe_character(const Show& show, std::uint32_t character) {
  const CharacterSource& source = show.stage().characters()[character];
  const anim::Skeleton& skeleton = source.character->skeleton;
  report_.character = character;
  described_ = source.character;
  report_.clip_names = source.clip_names;
  report_.suggested_role_clips = source.suggested;
  report_.level_bone_counts = skeleton.level_bone_counts;
  report_.placement = placement_of(source);
  report_.body = body_parts(source, show.stage().animated().rigs(character));
  describe_bones(*source.character);
  report_wardrobe_of(show.stage());
  described_scene_ = show.stage().tuning().scene;
  read_standard_rules(show.stage(), character, report_.wardrobe);
}

// Other rules dress all agents anew, so that looks of the same number follow the same rules.
void FrameReporter::report_wardrobe_of(const Stage& stage) {
  report_wardrobe(stage, report_.character, report_.wardrobe);
  reported_looks_ = stage.crowd().looks().number;
}

void FrameReporter::refuse_body(anim::BodyRole part, const std::string& why) {
  report_.body.refused = part;
  report_.body.refusal = why;
}

void FrameReporter::describe_bones(const anim::Character& character) {
  report_.bones.clear();
  for (const anim::BoneLodRow& row : character.bone_lod.rows) {
    const anim::Bone& bone = character.skeleton.bones[static_cast<std::size_t>(row.bone)];
    report_.bones.push_back(
        {.name = bone.name, .depth = depth_of(character.skeleton, row.bone), .parent = bone.parent, .lod = row});
  }
}

void FrameReporter::update(const Show& show, const CameraPose& camera, double frame_ms) {
  const anim::AnimationSystem& system = show.stage().system();
  if (!std::ranges::equal(show.stage().people(), report_.characters, {}, &CharacterSource::name)) {
    describe_characters(show);  // a replay has others from here on
  }
  const CharacterSource& shown = show.stage().characters()[report_.character];
  if (shown.character != described_ || shown.rig != report_.body.chosen) describe_character(show, report_.character);
  if (show.stage().tuning().scene != described_scene_) {
    described_scene_ = show.stage().tuning().scene;
    read_standard_rules(show.stage(), report_.character, report_.wardrobe);  // it has other styles
  }
  ++report_.frame;
  report_.notice = show.notice();
  if (!show.recorder().is_recording()) report_.recording.file.clear();
  report_.role_clips = show.stage().characters()[report_.character].roles.clips;
  report_.camera = camera;
  report_cameras(show, report_.cameras);
  report_.viewer = show.viewer() != nullptr ? std::optional(show.viewer()->report()) : std::nullopt;
  if (report_.viewer) return;  // the crowd waits, and so do its figures
  report_.situation = situation_of(show.stage(), mesh_levels_);
  report_.frame_ms = static_cast<float>(frame_ms);
  report_.update_ms = static_cast<float>(show.figures().times().animation_ms);
  report_.draw_ms = static_cast<float>(show.figures().times().drawing_ms());
  remember(report_.frame_ms_history, frame_ms);
  remember(report_.update_ms_history, show.figures().times().animation_ms);
  report_.agents = static_cast<int>(show.stage().crowd().size());
  add_moment(show.stage());
  add_cast(show.stage());
  if (show.stage().crowd().looks().number != reported_looks_) report_wardrobe_of(show.stage());
  report_.drawn = static_cast<int>(show.painter().picture().instances().size());
  report_.work = system.figures().report();
  report_.pose_hash = system.figures().pose_hash();
  report_.draw_counts = show.painter().draw_counts();
  add_level_of_detail(show.stage());
  report_.meshes = report_meshes(show, report_.character);
  report_.thresholds = show.painter().thresholds().thresholds();
  report_.threshold_clip = show.painter().thresholds().clip();
  add_heads(show.stage());
  add_units(system);
  report_.memory = system.figures().memory();
  limit_.add(show.figures().times());
  report_.limit_sentence = limit_.sentence(show.painter().is_on_software());
  add_error(show.stage());
  add_tracks(show.stage());
  report_.selected = report_selection(show.stage());
  const std::shared_ptr<const TrackedPerson> tracked = tracked_person_.report(show.stage());
  if (report_.selected) {
    report_.selected->tracked = tracked;
    selection_log_.update(show.stage(), *report_.selected);
  }
  report_.snapshots.clear();
  for (std::size_t i = 0; i < show.moments().count(); ++i) {
    report_.snapshots.push_back(static_cast<float>(to_seconds(show.moments().age(show.stage(), i))));
  }
}

void FrameReporter::add_moment(const Stage& stage) {
  const bool is_recorded = stage.crowd().tracks() != nullptr;
  report_.seconds = is_recorded ? stage.crowd().tracks()->clock().seconds : to_seconds(stage.system().clock());
  report_.people = report_.agents - static_cast<int>(std::ranges::count(absent_of(stage.crowd()), 1));
}

void FrameReporter::add_cast(const Stage& stage) {
  for (std::size_t i = 0; i < report_.cast.size(); ++i) {
    report_.cast[i].share = stage.people()[i].roles.share;
    report_.cast[i].agents = 0;
  }
  for (const std::uint8_t number : stage.crowd().characters()) {
    if (number < report_.cast.size()) ++report_.cast[number].agents;
  }
}

void FrameReporter::add_level_of_detail(const Stage& stage) {
  report_.visible = static_cast<int>(stage.posed().selection().visible.size());
  report_.agents_by_interval.assign(static_cast<std::size_t>(stage.tuning().lod.largest_interval), 0);
  report_.agents_by_bone_level.assign(report_.level_bone_counts.size(), 0);
  report_.lod = stage.posed().level_of_detail().figures();
  for (const anim::VisibleAgent& agent : stage.posed().selection().visible) {
    count(report_.agents_by_interval, agent.interval - 1U);
    count(report_.agents_by_bone_level, agent.bone_level);
  }
}

void FrameReporter::add_error(const Stage& stage) {
  const ErrorMeter& meter = stage.posed().error_meter();
  report_.error.figures = meter.figures();
  report_.error.intervals = meter.intervals();
  report_.error.p99_history.assign(meter.history().p99().begin(), meter.history().p99().end());
  report_.error.pop_history.assign(meter.history().pop().begin(), meter.history().pop().end());
  const bool skips = stage.tuning().lod.rule != LodRule::off;
  report_.error.skipping_sentence = skips ? skipping_sentence(limit_.mean(), report_.agents_by_interval) : "";
}

void FrameReporter::add_tracks(const Stage& stage) {
  const std::shared_ptr<const Trajectories>& all = stage.trajectories();
  // No person can go to another time of rows that still come.
  if (stage.crowd().tracks() == nullptr || all->is_live) return report_.tracks.reset();
  const bool is_counted = report_.tracks && tracks_ == all;
  report_.tracks = {.clock = stage.crowd().tracks()->clock(),
                    .people = is_counted ? report_.tracks->people : std::make_shared<const PeopleOverTime>(*all)};
  tracks_ = all;
}

// Reports the agents that are tallest on the screen, and the selected one even where it is small.
void FrameReporter::add_heads(const Stage& stage) {
  report_.heads.clear();
  if (!stage.tuning().ids && !stage.tuning().inspection.figures_above_heads) return;
  std::vector<anim::VisibleAgent> near(stage.posed().selection().visible.begin(),
                                       stage.posed().selection().visible.end());
  const auto shown = near.begin() + static_cast<std::ptrdiff_t>(std::min(near.size(), most_heads));
  std::ranges::partial_sort(near, shown, std::ranges::greater(), &anim::VisibleAgent::pixels_tall);
  for (const anim::VisibleAgent& agent : std::span(near.begin(), shown)) add_head(stage, agent);
  if (!stage.selected()) return;
  const auto selected = std::ranges::find(shown, near.end(), *stage.selected(), &anim::VisibleAgent::agent);
  if (selected != near.end()) add_head(stage, *selected);
}

void FrameReporter::add_head(const Stage& stage, const anim::VisibleAgent& agent) {
  const glm::vec3 foot = stage.crowd().positions()[agent.agent];
  const auto height = static_cast<float>(stage.character_of(agent.agent).character->bounds.height);
  HeadFigures& head = report_.heads.emplace_back();
  head.agent = agent.agent;
  head.x = foot.x;
  head.y = foot.y + stage.crowd().scales()[agent.agent] * height + above_head;
  head.z = foot.z;
  if (stage.tuning().ids) head.id = id_of_agent(stage, agent.agent);
  if (!stage.tuning().inspection.figures_above_heads) return;
  head.interval = agent.interval;
  head.bone_level = agent.bone_level;
}

void FrameReporter::add_units(const anim::AnimationSystem& system) {
  report_.schedule = system.figures().schedule();
  report_.simd_target = system.figures().kernels().target;
  report_.pu.clear();
  if (report_.timeline.size() == timeline_frames) report_.timeline.erase(report_.timeline.begin());
  TimelineFrame& frame =
      report_.timeline.emplace_back(TimelineFrame{.frame = report_.frame, .time = system.figures().update_time()});
  for (const anim::ProcessingUnit& unit : system.figures().units()) {
    report_.pu.push_back({.activity = unit.activity(), .local_store_laid_out_bytes = unit.store().bytes_used()});
    frame.lanes.push_back(joined_spans(unit.trace(), frame.time));
  }
  slow_frames_.add(report_.frame, report_.frame_ms, [this]() -> FrameDetails {
    return {.frame_ms = report_.frame_ms,
            .update_ms = report_.update_ms,
            .work = report_.work,
            .pu = report_.pu,
            .timeline = report_.timeline.back()};
  });
  report_.kept = slow_frames_.report();
}

}  // namespace throng::app
