#include "tests/anim/run/fused/tile_rig.h"

namespace throng::anim {

TileRig::TileRig(const CrowdRig& crowd) : store_(256 * 1024) {
  const Character& character = crowd->agent(0).character();
  for (const BakedClip& clip : character.clips) {
    clips_.push_back({.keyframe = clip.keyframe(), .sampled = clip.sampled(), .duration = clip.duration});
  }
  context_ = {.hierarchy = &character.hierarchy,
              .assets = {.clips = clips_,
                         .kernels = &crowd->figures().kernels(),
                         .bone_count = character.skeleton.bone_count(),
                         .components = character.skeleton.components()},
              .level_bone_counts = character.skeleton.level_bone_counts,
              .pools = &crowd->agent(0).pools()};
  StoreNeeds needs;
  for (std::uint32_t agent = 0; agent < crowd->agent_count(); ++agent) {
    const PoseProgram& program = crowd->agent(agent).program();
    needs.widen(program.needs);
    work_.push_back({.program = &program,
                     .entities = crowd->agent(agent).graph().entities.data(),
                     .delta = frame_ticks,
                     .agent = agent});
    if (runs_.empty() || runs_.back().program != &program) runs_.push_back({&program, agent, 0});
    ++runs_.back().count;
  }
  constexpr std::size_t fetch_bytes = 64 * 1024;
  store_.divide(fetch_bytes, 2, 2 * fetch_bytes);
  lists.reserve(fetch_bytes);
  ScratchCarver carver(store_.scratch());
  scratch_ = FusedScratch::carve(carver, context_, needs, width, work_.size());
}

TileInStore TileRig::tile() { return {.context = &context_, .work = work_, .runs = runs_, .blocks = blocks()}; }

Strip TileRig::strip(const TileInStore& tile, std::size_t first) const {
  return {.tile = &tile,
          .scratch = &scratch_,
          .first = first,
          .work = tile.work.subspan(first, width),
          .width = width,
          .packets = context_.packets(0),
          .held_packets = 0};
}

}  // namespace throng::anim
