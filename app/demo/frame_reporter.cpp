#include "app/demo/frame_reporter.h"

#include <algorithm>
#include <thread>

#include "app/demo/selection_reporter.h"
#include "app/figures/lod_sums.h"

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

constexpr double most_spans_in_a_lane = 512;
constexpr std::size_t timeline_frames = 8;
constexpr std::size_t most_heads = 300;
constexpr float above_head = 0.12F;  // metres

std::optional<PuSpan::Kind> kind_of(anim::TraceSpan::Kind kind) {
  switch (kind) {
    case anim::TraceSpan::Kind::fetch:
      return PuSpan::Kind::fetch;
    case anim::TraceSpan::Kind::compute:
      return PuSpan::Kind::compute;
    case anim::TraceSpan::Kind::write_back:
      return PuSpan::Kind::write_back;
    case anim::TraceSpan::Kind::wait:
      return PuSpan::Kind::wait;
    case anim::TraceSpan::Kind::schedule:
    case anim::TraceSpan::Kind::copy_slice:
      break;
  }
  return {};
}

// Tasks too short to be told apart in a lane become one span.
std::vector<PuSpan> spans_of(const anim::Trace& trace, const anim::UpdateTime& time) {
  const auto shortest = static_cast<float>(time.milliseconds / most_spans_in_a_lane);
  std::vector<PuSpan> spans;
  anim::JoinedContent content;  // of the last of them
  for (const anim::TraceSpan& span : trace.spans()) {
    const auto kind = kind_of(span.kind);
    if (!kind) continue;
    const auto end = static_cast<float>(time.ms(span.end));
    const bool joins = !spans.empty() && spans.back().kind == *kind && end - spans.back().begin_ms < shortest;
    if (!joins) {
      spans.push_back({.kind = *kind, .begin_ms = static_cast<float>(time.ms(span.begin))});
      content = {};
    }
    content.add(span.content);
    spans.back().content = content.all();
    spans.back().end_ms = end;
    spans.back().bytes_in += span.bytes_in;
    spans.back().bytes_out += span.bytes_out;
    spans.back().transfers += span.transfers;
  }
  return spans;
}

PuReport report_of(const anim::ProcessingUnit& unit, const anim::UpdateTime& time, double update_ms) {
  const anim::PuActivity& activity = unit.activity();
  PuReport report{.tiles = activity.tasks,
                  .agents = activity.agents,
                  .busy_ms = static_cast<float>(activity.busy_ms),
                  .wait_ms = static_cast<float>(std::max(0.0, update_ms - activity.busy_ms)),
                  .dma_in_bytes = activity.copies.bytes_in,
                  .dma_out_bytes = activity.copies.bytes_out,
                  .dma_transfers = activity.copies.transfers,
                  .local_store_laid_out_bytes = static_cast<std::uint32_t>(unit.store().bytes_used()),
                  .spans = spans_of(unit.trace(), time)};
  return report;
}

void count(std::vector<int>& counts, std::size_t place) {
  if (counts.size() <= place) counts.resize(place + 1, 0);
  ++counts[place];
}

}  // namespace

FrameReporter::FrameReporter(const Show& show) {
  describe_device(show);
  describe_characters(show);
}

void FrameReporter::describe_characters(const Show& show) {
  report_.characters.clear();
  for (const CharacterSource& character : show.stage().people()) report_.characters.push_back(character.name);
  describe_character(show, 0);
}

void FrameReporter::describe_device(const Show& show) {
  const DrawnBy drawn_by = show.drawn_by();
  report_.context = drawn_by.context;
  report_.gl_version = drawn_by.gl_version;
  report_.gl_renderer = drawn_by.gl_renderer;
  report_.software_renderer = show.on_software();
  report_.hardware_threads = static_cast<int>(std::thread::hardware_concurrency());
}

void FrameReporter::describe_character(const Show& show, std::size_t character) {
  const CharacterSource& source = show.stage().characters()[character];
  const anim::Skeleton& skeleton = source.character->skeleton;
  report_.character = character;
  report_.clip_names = source.clip_names;
  report_.suggested_role_clips = source.suggested;
  report_.level_bone_counts = skeleton.level_bone_counts;
  describe_bones(*source.character);
}

void FrameReporter::describe_bones(const anim::Character& character) {
  constexpr float millimetres = 1000.0F;
  report_.bones.clear();
  for (const anim::BoneLodRow& row : character.bone_lod.rows) {
    const anim::Bone& bone = character.skeleton.bones[static_cast<std::size_t>(row.bone)];
    report_.bones.push_back({.name = bone.name,
                             .depth = depth_of(character.skeleton, row.bone),
                             .level = row.level,
                             .parent = bone.parent,
                             .error_millimetres = row.error_metres * millimetres,
                             .nanoseconds = static_cast<float>(nanoseconds_a_bone())});
  }
  report_.level_error_millimetres.clear();
  for (const float metres : character.bone_lod.level_error_metres) {
    report_.level_error_millimetres.push_back(metres * millimetres);
  }
  report_.level_error_millimetres.resize(character.skeleton.level_bone_counts.size());
}

void FrameReporter::update(const Show& show, const CameraPlace& camera, double frame_ms, const std::string& notice) {
  const anim::AnimationSystem& system = show.stage().system();
  ++report_.frame;
  report_.notice = notice;
  report_.role_clips = show.stage().characters()[report_.character].roles.clips;
  report_.camera = camera;
  report_.frame_ms = static_cast<float>(frame_ms);
  report_.update_ms = static_cast<float>(show.last_update_ms());
  report_.draw_ms = static_cast<float>(show.last_draw_ms());
  remember(report_.frame_ms_history, frame_ms);
  remember(report_.update_ms_history, show.last_update_ms());
  report_.agents = static_cast<int>(show.stage().crowd().size());
  report_.drawn = static_cast<int>(show.picture().instances().size());
  report_.agents_updated = static_cast<int>(system.figures().report().agents_updated);
  report_.bones_evaluated = system.figures().report().bones_evaluated;
  report_.pose_hash = system.figures().pose_hash();
  report_.draw_calls = show.draw_counts().draw_calls;
  report_.triangles = show.draw_counts().triangles;
  add_level_of_detail(show.stage());
  report_.thresholds = show.thresholds().thresholds();
  report_.threshold_clip = show.thresholds().clip();
  add_heads(show.stage());
  add_units(system, show.last_update_ms());
  remember_timeline();
  add_memory(system);
  limit_.add(show.frame_times());
  report_.limit_sentence = limit_.sentence();
  report_.selected = report_selection(show.stage());
  if (report_.selected) selection_log_.update(show.stage(), *report_.selected);
  report_.snapshots = static_cast<int>(show.moments().count());
  report_.snapshot_seconds = static_cast<float>(anim::to_seconds(show.moments().age(show.stage())));
}

void FrameReporter::add_memory(const anim::AnimationSystem& system) {
  report_.memory.clear();
  for (const anim::KindMemory& kind : system.figures().memory()) {
    const std::size_t blocks = kind.own.blocks_alive + kind.shared.blocks_alive;
    if (blocks == 0) continue;
    report_.memory.push_back({.kind = kind.kind,
                              .blocks = blocks,
                              .bytes = kind.own.bytes_alive + kind.shared.bytes_alive,
                              .reserved_bytes = kind.own.bytes_reserved + kind.shared.bytes_reserved});
  }
}

void FrameReporter::add_level_of_detail(const Stage& stage) {
  report_.visible = static_cast<int>(stage.selection().visible.size());
  report_.agents_by_interval.assign(static_cast<std::size_t>(stage.tuning().lod.largest_interval), 0);
  report_.agents_by_bone_level.assign(report_.level_bone_counts.size(), 0);
  const anim::ErrorFigures& error = stage.error();
  report_.error_px_p50 = error.p50;
  report_.error_px_p99 = error.p99;
  report_.error_px_max = error.max;
  report_.pop_px_max = error.pop_max;
  report_.error_samples = static_cast<int>(error.samples);
  report_.error_px_p99_is_known = error.p99_is_known();
  for (const anim::VisibleAgent& agent : stage.selection().visible) {
    count(report_.agents_by_interval, agent.interval - 1U);
    count(report_.agents_by_bone_level, agent.bone_level);
  }
  add_limits(stage);
}

void FrameReporter::add_limits(const Stage& stage) {
  const LodFigures& figures = stage.level_of_detail().figures();
  const SavedCost saved = saved_cost(figures.cost, stage.tuning().lod.rule);
  report_.lod_tolerance_px = figures.tolerance_px;
  report_.binding_limit = stage.tuning().lod.rule == anim::LodRule::budget ? name_of(figures.binding) : "";
  report_.predicted_pose_ms = static_cast<float>(figures.predicted_ms);
  report_.budget_held = figures.budget_held;
  report_.cost_culling_percent = static_cast<float>(saved.culling_percent);
  report_.cost_skipping_percent = static_cast<float>(saved.skipping_percent);
  report_.cost_bones_percent = static_cast<float>(saved.bones_percent);
}

void FrameReporter::add_heads(const Stage& stage) {
  report_.heads.clear();
  if (!stage.tuning().inspection.figures_above_heads) return;
  std::vector<anim::VisibleAgent> near(stage.selection().visible.begin(), stage.selection().visible.end());
  const auto shown = near.begin() + static_cast<std::ptrdiff_t>(std::min(near.size(), most_heads));
  std::ranges::partial_sort(near, shown, std::ranges::greater(), &anim::VisibleAgent::pixels_tall);
  for (const anim::VisibleAgent& agent : std::span(near.begin(), shown)) {
    const glm::vec3 foot = stage.crowd().positions()[agent.agent];
    const auto height = static_cast<float>(stage.character_of(agent.agent).bounds.height);
    report_.heads.push_back({.x = foot.x,
                             .y = foot.y + stage.crowd().scales()[agent.agent] * height + above_head,
                             .z = foot.z,
                             .interval = agent.interval,
                             .bone_level = agent.bone_level});
  }
}

void FrameReporter::add_units(const anim::AnimationSystem& system, double update_ms) {
  const anim::ScheduleOptions& schedule = system.figures().schedule();
  report_.pus = schedule.pus;
  report_.local_store_kib = static_cast<int>(schedule.local_store_bytes / 1024);
  report_.tile = schedule.plan.width;
  report_.simd_target = system.figures().kernels().target;
  report_.dma_in_bytes = system.figures().report().copies.bytes_in;
  report_.dma_out_bytes = system.figures().report().copies.bytes_out;
  report_.dma_transfers = system.figures().report().copies.transfers;
  report_.palette_bytes = system.figures().report().palette_bytes;
  report_.pu.clear();
  report_.local_store_laid_out_bytes = 0;
  for (const anim::ProcessingUnit& unit : system.figures().units()) {
    report_.pu.push_back(report_of(unit, system.figures().update_time(), update_ms));
    report_.local_store_laid_out_bytes =
        std::max(report_.local_store_laid_out_bytes, report_.pu.back().local_store_laid_out_bytes);
  }
}

void FrameReporter::remember_timeline() {
  if (report_.timeline.size() == timeline_frames) report_.timeline.pop_front();
  TimelineFrame& frame = report_.timeline.emplace_back();
  frame.frame = report_.frame;
  for (const PuReport& pu : report_.pu) {
    frame.lanes.push_back(pu.spans);
    if (!pu.spans.empty()) frame.length_ms = std::max(frame.length_ms, pu.spans.back().end_ms);
  }
}

}  // namespace throng::app
