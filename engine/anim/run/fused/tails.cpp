// The last steps of most programs read the one before and nothing else: they change poses where they lie, side by side
// for many characters of a tile.

#include "engine/anim/run/fused/characters.h"
#include "engine/anim/run/store/pose_entity.h"

namespace throng::anim {
namespace {

void pose_whole_round(const PosedEntities& round, int packets) {
  const EntityKind& kind = *round.alike.layout->kind;
  if (kind.pose_strip != nullptr) return kind.pose_strip(round);
  for (std::size_t i = 0; i < round.size(); ++i) {
    const PoseView pose = round.pose(i);
    pose_entity(round.entity(i), {&pose, 1}, pose, packets, nullptr);
  }
}

void pose_packet_round(const PacketsJob& job) {
  const EntityKind& kind = *job.all.alike.layout->kind;
  if (kind.whole_pose()) return;  // whose bones all lie in held packets
  if (kind.pose_packets != nullptr) return kind.pose_packets(job);
  for (std::size_t i = 0; i < job.all.size(); ++i) {
    float* const bones = job.bones_of(i);
    kind.pose_packet(job.all.entity(i), {.packet = job.packet, .sources = &bones, .out = bones});
  }
}

}  // namespace

/// Its first packet is where streamed ones lie, too.
PoseView FusedTasks::pose_of(const Characters& characters, std::size_t character) const {
  return {&scratch_.model.local[character * characters.context->packet_floats()], held_stride(characters),
          characters.context->assets.components, characters.context->bones(characters.work.front().level),
          displaced_quads()};
}

/// In each round, of the characters that are not at that end of their programs, those whose next step is laid out as
/// the first one's.
void FusedTasks::add_rounds(const Characters& characters, EndOfSteps end) {
  for (;;) {
    const EntityLayout* common = nullptr;
    for (Composed& composed : std::span(composed_).first(composed_count_)) {
      if (composed.tail.step >= end(composed.program())) continue;
      const EntityLayout& layout = composed.program().steps[composed.tail.step].layout(*characters.context->pools);
      if (common == nullptr) common = &layout;
      if (&layout != common) continue;
      StepPlace place = composed.tail;
      float* pose = pose_of(characters, composed.characters.first).first;
      for (std::size_t c = composed.characters.first; c < composed.characters.end; ++c) {
        notes_->tails.add({.block = place.block, .prepared = place.prepared, .pose = pose});
        place = place.of_next(composed.program());
        pose += characters.context->packet_floats();
      }
      composed.tail.pass(layout);
    }
    if (common == nullptr) return;
    notes_->tails.end_round(*common);
    composed_displaces_ |= common->kind->displaced_quads;
  }
}

/// Those that reach for whole poses, and what comes before them, first.
void FusedTasks::plan_tails(const Characters& characters) {
  notes_->tails.clear();
  add_rounds(characters, [](const PoseProgram& program) -> std::size_t { return program.packet_tail; });
  whole_rounds_ = notes_->tails.count();
  add_rounds(characters, [](const PoseProgram& program) { return program.steps.size(); });
}

PosedEntities FusedTasks::tail_round(const Characters& characters, std::size_t round) const {
  return {.places = notes_->tails.places(round),
          .alike = {.block = nullptr,
                    .prepared = nullptr,
                    .layout = &notes_->tails.layout(round),
                    .assets = &characters.context->assets},
          .poses_alike = pose_of(characters, 0)};
}

void FusedTasks::pose_whole_tails(const Characters& characters) const {
  for (std::size_t i = 0; i < whole_rounds_; ++i) pose_whole_round(tail_round(characters, i), characters.held_packets);
}

void FusedTasks::pose_held_tails(const Characters& characters, int packet) const {
  const std::size_t offset = static_cast<std::size_t>(packet) * held_stride(characters);
  for (std::size_t i = whole_rounds_; i < notes_->tails.count(); ++i) {
    pose_packet_round({.all = tail_round(characters, i), .packet = packet, .offset = offset});
  }
}

void FusedTasks::pose_streamed_tails(const Characters& characters, int packet) const {
  for (std::size_t i = 0; i < notes_->tails.count(); ++i) {
    pose_packet_round({.all = tail_round(characters, i), .packet = packet});
  }
}

}  // namespace throng::anim
