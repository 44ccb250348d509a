#include "engine/anim/run/fused_tasks.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "engine/anim/run/fused_characters.h"

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
  return {last ? clips_.row(alike.first) : &shown(step, alike.first), alike.size()};
}

int FusedTasks::copy_points(int task) const {
  const int packets = context(task).packets(agents(task).front().level);
  return packets + std::min<int>(tile_of(task).needs.held_packets, packets);
}

/// Moves their entities, step by step, and notes which clips each shows.
void FusedTasks::advance_alike(const Characters& characters, const AlikeRun& alike, StepPlace place) {
  const PoseProgram& program = *alike.program;
  LeftBySteps<SourceRow> rows;
  std::array<SourceRow, max_sources> sources;
  for_each_shared(program, [&](std::size_t i, const PoseStep& step) {
    const auto& state = characters.shared_state(step.shared);
    const std::span<ShownClips> shown = shown_by(i, alike);
    std::ranges::fill(shown, ShownClips{});
    rows.left[i] = {reinterpret_cast<const std::byte*>(&state), 0, shown.data()};
  });
  for_each_own(*characters.context, program, place, program.steps.size(),
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

/// Some step before the tail may give bones other positions than the clips below it do.
bool FusedTasks::head_displaces(const EntityPools& pools, const Composed& composed) {
  if (composed.base == Composed::no_base) return true;
  for (std::size_t i = 0; i < composed.program().tail; ++i) {
    const PoseStep& step = composed.program().steps[i];
    if (composed.poses(i) && (step.is_shared() || step.layout(pools).kind->displaces)) return true;
  }
  return false;
}

/// The quads whose bones may have positions other than 0.
std::uint64_t FusedTasks::displaced_quads() const {
  return composed_displaces_ ? ~std::uint64_t{0} : clips_.displaced_quads();
}

/// Those whose poses are not clips alone; who follows one that is composed in the same way joins it.
void FusedTasks::find_composed(const Characters& characters, const AlikeRun& alike, StepPlace place) {
  Composed* newest = nullptr;
  for (std::size_t character = alike.first; character < alike.end; ++character) {
    if (clips_.row(character)->clip == nullptr) {
      const std::size_t base = base_of(*alike.program, character);
      if (base != Composed::no_base) *clips_.row(character) = shown(base, character);
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
  composed_displaces_ = composed_displaces_ || head_displaces(*characters.context->pools, composed);
  return composed;
}

void FusedTasks::advance_entities(const Characters& characters) {
  clips_.begin(characters.work.size());
  composed_count_ = 0;
  composed_displaces_ = false;
  StepPlace place{.block = characters.blocks, .prepared = scratch_.prepared.data()};
  for_each_alike(characters.work, characters.program, [&](const AlikeRun& alike) {
    advance_alike(characters, alike, place);
    if (!clips_.all_show(alike.first, alike.end)) find_composed(characters, alike, place);
    clips_.add(alike.first, alike.end);
    place = place.of_next(*alike.program, alike.size());
  });
  plan_tails(characters);
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
void FusedTasks::carve_scratch(const UpdateContext& context, const StoreNeeds& needs, int width) {
  if (carved_.context == &context && carved_.needs == needs && carved_.width == width) return;
  carved_ = {&context, needs, width};
  ScratchCarver carver(store_->scratch());
  scratch_ = FusedScratch::carve(carver, context, needs, width);
}

void FusedTasks::compute(int task, int buffer, CopyEngine& engine) {
  const std::span<const AgentWork> tile = agents(task);
  const UpdateContext& about = context(task);
  const StoreNeeds& needs = tile_of(task).needs;
  const bool shares = needs.shared > 0;
  if (shares) shared_ = SharedSources(tile);
  std::byte* const blocks = store_->fetch_buffer(buffer).data();
  const Characters characters{.context = &about,
                              .work = tile,
                              .program = tile_of(task).program,
                              .blocks = blocks,
                              .shared = shares ? &shared_ : nullptr,
                              .shared_blocks = shares ? blocks + own_bytes(tile) : nullptr,
                              .width = static_cast<int>(std::bit_ceil(tile.size())),
                              .packets = about.packets(tile.front().level),
                              .held_packets = std::min<int>(needs.held_packets, about.packets(tile.front().level))};
  carve_scratch(about, needs, characters.width);
  // Lanes beyond the last character compute on numbers, not on noise.
  if (tile.size() < static_cast<std::size_t>(characters.width)) {
    std::ranges::fill(needs.held ? scratch_.held : scratch_.model.local, 0.0F);
  }
  for (std::size_t i = 0; i < tile.size(); ++i) notes_->deltas[i] = tile[i].delta;
  advance_entities(characters);
  write_back_final_rows(task, buffer, engine);
  TilePalettes palettes(about, scratch_.model, tile, characters.width, stores_);
  if (needs.held) compute_held(characters, palettes, engine);
  compute_streaming(characters, palettes, engine);
  palettes.store_hashes();
  ++tiles_done_;
  agents_done_ += static_cast<std::uint32_t>(tile.size());
}

// What all packets need is looked up before the first: kernels leave nothing else in the nearest cache.
void FusedTasks::compute_streaming(const Characters& characters, TilePalettes& palettes, CopyEngine& engine) const {
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
