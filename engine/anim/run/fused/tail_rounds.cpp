#include "engine/anim/run/fused/tail_rounds.h"

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
  if (kind.whole_pose()) return;  // all its bones lie in held packets
  if (kind.pose_packets != nullptr) return kind.pose_packets(job);
  for (std::size_t i = 0; i < job.all.size(); ++i) {
    float* const bones = job.bones_of(i);
    kind.pose_packet(job.all.entity(i), {.packet = job.packet, .sources = &bones, .out = bones});
  }
}

}  // namespace

void TailRounds::reserve(std::size_t blocks) {
  entities_.resize(blocks);
  rounds_.resize(blocks);
}

std::size_t TailRounds::bytes() const {
  return entities_.capacity() * sizeof(PosedEntities::Place) + rounds_.capacity() * sizeof(Round);
}

/// A round has, of the characters that are not at `end` yet, all whose next step has the layout of the first one's.
void TailRounds::add_rounds(const Strip& strip, std::span<ComposedRun> composed, EndOfSteps end) {
  const UpdateContext& context = strip.context();
  for (;;) {
    const EntityLayout* common = nullptr;
    for (ComposedRun& run : composed) {
      if (run.tail.step >= end(run.program())) continue;
      const EntityLayout& layout = run.program().steps[run.tail.step].layout(*context.pools);
      if (common == nullptr) common = &layout;
      if (&layout != common) continue;
      StepCursor cursor = run.tail;
      float* pose = strip.pose(run.characters.first);
      for (std::size_t i = 0; i < run.characters.count; ++i) {
        entities_[entity_count_++] = {.block = cursor.block, .prepared = cursor.prepared, .pose = pose};
        cursor = cursor.of_next(run.program());
        pose += context.packet_floats();
      }
      run.tail.pass(layout);
    }
    if (common == nullptr) return;
    rounds_[round_count_++] = {common, static_cast<std::uint32_t>(entity_count_)};
    displaced_quads_ |= common->kind->displaced_quads;
  }
}

void TailRounds::sort(const Strip& strip, std::span<ComposedRun> composed) {
  entity_count_ = 0;
  round_count_ = 0;
  displaced_quads_ = 0;
  add_rounds(strip, composed, [](const PoseProgram& program) -> std::size_t { return program.packet_tail; });
  whole_rounds_ = round_count_;
  add_rounds(strip, composed, [](const PoseProgram& program) { return program.steps.size(); });
}

PosedEntities TailRounds::entities_of(const Strip& strip, const PoseView& first, std::size_t round) const {
  return {.places = entities(round),
          .alike = {.block = nullptr, .prepared = nullptr, .layout = &layout(round), .assets = &strip.context().assets},
          .poses_alike = first};
}

void TailRounds::pose_whole(const Strip& strip, const PoseView& first) const {
  for (std::size_t i = 0; i < whole_rounds_; ++i) pose_whole_round(entities_of(strip, first, i), strip.held_packets);
}

void TailRounds::pose_packet(const Strip& strip, const PoseView& first, int packet) const {
  const bool held = packet < strip.held_packets;
  const std::size_t offset = held ? static_cast<std::size_t>(packet) * strip.held_stride() : 0;
  for (std::size_t i = held ? whole_rounds_ : 0; i < round_count_; ++i) {
    pose_packet_round({.all = entities_of(strip, first, i), .packet = packet, .offset = offset});
  }
}

}  // namespace throng::anim
