#include "engine/anim/run/store/pose_entity.h"

#include <array>
#include <cstring>

namespace throng::anim {
namespace {

void pose_packets(const EntityInStore& entity, std::span<const PoseView> sources, const PoseView& out, int packets,
                  CopyEngine* engine) {
  std::array<const float*, max_sources> source_packets;
  for (int packet = 0; packet < packets; ++packet) {
    for (std::size_t i = 0; i < sources.size(); ++i) source_packets[i] = sources[i].packet(packet);
    entity.layout->kind->pose_packet(entity,
                                     {.packet = packet, .sources = source_packets.data(), .out = out.packet(packet)});
    if (engine != nullptr) engine->advance();
  }
}

}  // namespace

void pose_entity(const EntityInStore& entity, std::span<const PoseView> sources, const PoseView& out, int packets,
                 CopyEngine* engine) {
  if (!entity.layout->kind->whole_pose()) return pose_packets(entity, sources, out, packets, engine);
  if (!sources.empty()) copy_pose(sources.front(), out, packets);
  entity.layout->kind->pose_whole(entity, out);
  for (int packet = 0; packet < packets && engine != nullptr; ++packet) engine->advance();
}

void copy_pose(const PoseView& from, const PoseView& to, int packets) {
  if (from.first == to.first) return;
  for (int packet = 0; packet < packets; ++packet) {
    std::memcpy(to.packet(packet), from.packet(packet), packet_bytes(to.components));
  }
}

}  // namespace throng::anim
