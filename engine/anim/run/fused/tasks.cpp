#include "engine/anim/run/fused/tasks.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "engine/anim/run/fused/characters.h"

namespace throng::anim {

namespace {

/// The steps that have to be posed where `base` already is.
template <typename IsPosed>
std::uint64_t steps_over(const PoseProgram& program, std::size_t base, IsPosed&& is_posed) {
  static_assert(PoseProgram::max_steps <= 64);
  std::uint64_t wanted = std::uint64_t{1} << (program.steps.size() - 1);
  for (std::size_t i = program.steps.size(); i-- > 0;) {
    const PoseStep& step = program.steps[i];
    if ((wanted >> i & 1U) == 0 || i == base || is_posed(i)) continue;
    for (std::size_t k = 0; k < step.source_count; ++k) wanted |= std::uint64_t{1} << step.sources[k];
  }
  return wanted;
}

}  // namespace

std::span<const AgentWork> FusedTasks::agents(int task) const {
  return work_.subspan(tile_of(task).first, tile_of(task).count);
}

/// Room for what these characters show after a step.
std::span<ShownClips> FusedTasks::shown_by(std::size_t step, const AlikeRun& alike) {
  const bool last = step + 1 == alike.program->steps.size();
  const std::size_t row = step * most_characters;
  return {last ? &notes_->shown_last[alike.first] : &notes_->shown[row + alike.first], alike.size()};
}

int FusedTasks::copy_points(int task) const {
  const Tile& tile = tile_of(task);
  const int packets = context(task).packets(agents(task).front().level);
  return static_cast<int>(tile.strips()) * (packets + std::min<int>(tile.needs.held_packets, packets));
}

/// Moves their entities, step by step, and notes which clips each shows.
void FusedTasks::advance_alike(const Characters& tile, const AlikeRun& alike, StepPlace place) {
  const PoseProgram& program = *alike.program;
  LeftBySteps<SourceRow> rows;
  std::array<SourceRow, max_sources> sources;
  for_each_shared(program, [&](std::size_t i, const PoseStep& step) {
    const auto& state = tile.shared_state(step.shared);
    const std::span<ShownClips> shown = shown_by(i, alike);
    std::ranges::fill(shown, ShownClips{});
    rows.left[i] = {reinterpret_cast<const std::byte*>(&state), 0, shown.data()};
  });
  for_each_own(*tile.context, program, place, program.steps.size(),
               [&](std::size_t i, const PoseStep& step, const EntityInStore& entity) {
                 const std::span<ShownClips> shown = shown_by(i, alike);
                 const bool asked = !entity.layout->is_resident();
                 if (!asked) std::ranges::fill(shown, ShownClips{});
                 const EntityRun run{.first = entity,
                                     .count = alike.size(),
                                     .block_stride = program.needs.fetch_bytes,
                                     .prepared_stride = program.needs.prepared_bytes,
                                     .sources = rows.sources(step, sources),
                                     .deltas = &notes_->deltas[alike.first],
                                     .shown = asked ? shown.data() : nullptr};
                 entity.layout->kind->advance(run);
                 rows.left[i] = {entity.block, run.block_stride, shown.data()};
               });
}

/// The last step that shows clips which others, that do not, read. The very last does not.
std::size_t FusedTasks::base_of(const PoseProgram& program, std::size_t character) {
  const auto shows_clips = [&](std::size_t i) { return shown(i, character).clip != nullptr; };
  const std::size_t root = program.steps.size() - 1;
  for (std::size_t i = root; i-- + 1 > program.tail;) {
    if (shows_clips(i)) return i;
  }
  const auto is_posed = [&](std::size_t i) { return i != root && shows_clips(i); };
  const std::uint64_t wanted = steps_over(program, Composed::no_base, is_posed);
  for (std::size_t i = root; i-- > 0;) {
    if ((wanted >> i & 1U) != 0 && shows_clips(i)) return i;
  }
  return Composed::no_base;
}

/// Where some step before the tail may give bones other positions than the clips below it do.
std::uint64_t FusedTasks::quads_displaced_by_head(const EntityPools& pools, const Composed& composed) {
  constexpr std::uint64_t all = ~std::uint64_t{0};
  if (composed.base == Composed::no_base) return all;
  std::uint64_t quads = 0;
  for (std::size_t i = 0; i < composed.program().tail; ++i) {
    const PoseStep& step = composed.program().steps[i];
    if (composed.poses(i)) quads |= step.is_shared() ? all : step.layout(pools).kind->displaced_quads;
  }
  return quads;
}

/// The quads whose bones may have positions other than 0.
std::uint64_t FusedTasks::displaced_quads() const { return composed_displaces_ | clips_.displaced_quads(); }

/// Those whose poses are not clips alone; who follows one that is composed in the same way joins it.
void FusedTasks::find_composed(const Characters& characters, const AlikeRun& alike, StepPlace place) {
  Composed* newest = nullptr;
  for (std::size_t character = alike.first; character < alike.end; ++character) {
    if (clips_.of(character).clip == nullptr) {
      const std::size_t base = base_of(*alike.program, character);
      if (base != Composed::no_base) clips_.of(character) = shown(base, character);
      if (newest != nullptr && newest->characters.end == character && newest->base == base) {
        ++newest->characters.end;
      } else {
        newest = &begin_composed(characters, {character, character + 1, alike.program}, place, base);
      }
    }
    place = place.of_next(*alike.program);
  }
}

FusedTasks::Composed& FusedTasks::begin_composed(const Characters& characters, const AlikeRun& first,
                                                 const StepPlace& place, std::size_t base) {
  const PoseProgram& program = *first.program;
  Composed& composed = composed_[composed_count_++];
  composed = {.characters = first,
              .head = place,
              .tail = place.at_tail(program),
              .base = base,
              .over_clips = base != Composed::no_base && base + 1 >= program.tail};
  if (composed.over_clips) {
    for_each_own(*characters.context, program, composed.tail, base + 1, [](auto&&...) {});
    return composed;
  }
  composed.wanted = steps_over(program, base, [](std::size_t) { return false; });
  composed_displaces_ |= quads_displaced_by_head(*characters.context->pools, composed);
  return composed;
}

void FusedTasks::advance_entities(const Characters& tile, StepPlace place) {
  for_each_alike(tile.work, tile.program, [&](const AlikeRun& alike) {
    advance_alike(tile, alike, place);
    place = place.of_next(*alike.program, alike.size());
  });
}

/// What becomes of what its characters show, the first of whom is at `place`; then that is where those after them are.
void FusedTasks::plan_poses(const Characters& strip, StepPlace& place) {
  clips_.begin(std::span(notes_->shown_last).subspan(posed_, strip.work.size()));
  composed_count_ = 0;
  composed_displaces_ = 0;
  for_each_alike(strip.work, strip.program, [&](const AlikeRun& alike) {
    if (!clips_.all_show(alike.first, alike.end)) find_composed(strip, alike, place);
    clips_.add(alike.first, alike.end);
    place = place.of_next(*alike.program, alike.size());
  });
  plan_tails(strip);
}

/// What comes before the tail of a program: entity after entity, over clips that are there already.
void FusedTasks::compose_packet(const Characters& characters, const Composed& composed, std::size_t character,
                                StepPlace place, int packet) const {
  const PoseProgram& program = *characters.work[character].program;
  const std::size_t floats = characters.context->packet_floats();
  const std::size_t offset = static_cast<std::size_t>(packet) * floats;
  float* const local = &scratch_.model.local[character * floats];
  LeftBySteps<const float*> poses;
  std::array<const float*, max_sources> sources;
  const std::size_t last = program.tail - std::size_t{1};
  for_each_shared(program, [&](std::size_t i, const PoseStep& step) {
    poses.left[i] = transforms_of(characters.shared_state(step.shared)) + offset;
  });
  if (composed.base != Composed::no_base) poses.left[composed.base] = local;
  for_each_own(*characters.context, program, place, last + 1,
               [&](std::size_t i, const PoseStep& step, const EntityInStore& entity) {
                 if (!composed.poses(i)) return;
                 const EntityKind& kind = *entity.layout->kind;
                 if (kind.whole_pose()) {
                   poses.left[i] = poses.left[step.sources[0]];  // whose bones all lie in held packets
                   return;
                 }
                 float* out = i == last ? local : &scratch_.registers[step.target * floats];
                 if (entity.layout->is_resident()) out = transforms_of(entity.as<AnimationStateHeader>()) + offset;
                 kind.pose_packet(entity,
                                  {.packet = packet, .sources = poses.sources(step, sources).data(), .out = out});
                 poses.left[i] = out;
               });
  if (poses.left[last] != local) std::memcpy(local, poses.left[last], floats * sizeof(float));
}

/// Nearly always as for the tile before.
void FusedTasks::carve_scratch(const Carved& wanted) {
  if (carved_ == wanted) return;
  carved_ = wanted;
  ScratchCarver carver(store_->scratch());
  scratch_ = FusedScratch::carve(carver, *wanted.context, wanted.needs, wanted.width, wanted.characters);
}

void FusedTasks::compute(int task, int buffer, CopyEngine& engine) {
  const std::span<const AgentWork> work = agents(task);
  const UpdateContext& about = context(task);
  const Tile& cut = tile_of(task);
  const bool shares = cut.needs.shared > 0;
  if (shares) shared_ = SharedSources(work);
  std::byte* const blocks = store_->fetch_buffer(buffer).data();
  const int packets = about.packets(work.front().level);
  Characters characters{.context = &about,
                        .work = work,
                        .program = cut.program,
                        .shared = shares ? &shared_ : nullptr,
                        .shared_blocks = shares ? blocks + own_bytes(work) : nullptr,
                        .width = static_cast<int>(std::bit_ceil(std::min(cut.count, cut.width))),
                        .packets = packets,
                        .held_packets = std::min<int>(cut.needs.held_packets, packets)};
  carve_scratch({&about, cut.needs, characters.width, work.size()});
  for (std::size_t i = 0; i < work.size(); ++i) notes_->deltas[i] = work[i].delta;
  StepPlace place{.block = blocks, .prepared = scratch_.prepared.data()};
  advance_entities(characters, place);
  write_back_final_rows(task, buffer, engine);
  for (posed_ = 0; posed_ < work.size(); posed_ += cut.width) {
    characters.work = work.subspan(posed_, std::min<std::size_t>(cut.width, work.size() - posed_));
    characters.width = static_cast<int>(std::bit_ceil(characters.work.size()));
    plan_poses(characters, place);
    pose(characters, engine);
  }
  ++tiles_done_;
  agents_done_ += cut.count;
}

void FusedTasks::pose(const Characters& strip, CopyEngine& engine) {
  const bool held = carved_.needs.held;
  // Lanes beyond the last character compute on numbers, not on noise.
  if (strip.work.size() < static_cast<std::size_t>(strip.width)) {
    std::ranges::fill(held ? scratch_.held : scratch_.model.local, 0.0F);
  }
  StripPalettes palettes(*strip.context, scratch_.model, strip.work, strip.width, stores_);
  if (held) compute_held(strip, palettes, engine);
  compute_streaming(strip, palettes, engine);
  palettes.store_hashes();
}

// What all packets need is looked up before the first: kernels leave nothing else in the nearest cache.
void FusedTasks::compute_streaming(const Characters& characters, StripPalettes& palettes, CopyEngine& engine) const {
  const EntityAssets& assets = characters.context->assets;
  const auto pose_clips = assets.kernels->pose_clips;
  const bool shows_clips = !clips_.empty(), composes = composed_count_ > 0;
  const std::uint64_t displaced = displaced_quads();
  float* const local = scratch_.model.local.data();
  PoseClipsJob clips = clips_.job(assets.components, local);
  const int packets = characters.packets;
  for (int packet = characters.held_packets; packet < packets; ++packet) {
    clips.packet = packet;
    clips.displaced = quads_of_packet(displaced, packet);
    if (shows_clips) pose_clips(clips);
    if (composes) compose_streamed_packet(characters, packet);
    palettes.write({.packet = packet, .local = local, .displaced = clips.displaced});
    engine.advance();
  }
}

/// What is more than clips.
void FusedTasks::compose_streamed_packet(const Characters& characters, int packet) const {
  for_each_head([&](const Composed& composed, std::size_t character, const StepPlace& place) {
    compose_packet(characters, composed, character, place, packet);
  });
  pose_streamed_tails(characters, packet);
}

}  // namespace throng::anim
