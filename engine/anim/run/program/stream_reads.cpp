#include "engine/anim/run/program/stream_reads.h"

#include <algorithm>
#include <cstdlib>

namespace throng::anim {
namespace {

std::uint64_t of_rows(const SampledStream& stream, int packets) {
  const auto whole = static_cast<std::uint64_t>(stream.row_stride) * static_cast<std::uint64_t>(packets);
  return 2 * whole / static_cast<std::uint64_t>(std::max(stream.packet_count(), 1));
}

std::uint64_t of_keys(const KeyframeStream& stream, Ticks passed, Ticks duration) {
  const double loops =
      duration > Ticks{} ? static_cast<double>(std::abs(passed.count())) / static_cast<double>(duration.count()) : 0.0;
  return static_cast<std::uint64_t>(std::min(loops, 1.0) * stream.total_size);
}

}  // namespace

std::uint64_t stream_bytes_read(const UpdateContext& context, const AgentWork& work) {
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < work.program->steps.size(); ++i) {
    const PoseStep& step = work.program->steps[i];
    if (step.is_shared() || step.source_count > 0) continue;
    const EntityType type = step.layout(*context.pools).kind->type;
    if (type != EntityType::sampled_player && type != EntityType::keyframe_player) continue;
    const auto& player = context.pools->as<Player>(work.entities[i]);
    const ClipStreams& clip = context.assets.clips[player.clip];
    if (type == EntityType::sampled_player) {
      bytes += of_rows(*clip.sampled, context.packets(work.level));
    } else {
      const double speed = static_cast<double>(player.speed) / 65536.0;
      bytes +=
          of_keys(*clip.keyframe, Ticks{static_cast<std::int64_t>(static_cast<double>(work.delta.count()) * speed)},
                  clip.duration);
    }
  }
  return bytes;
}

}  // namespace throng::anim
