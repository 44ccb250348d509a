#include "app/show/picture.h"

#include "app/settings/agent_colors.h"
#include "app/show/stage/stage.h"
#include "engine/base/tiles.h"

namespace throng::app {
namespace {

/// Calls visit(place) for each place in view, on the PUs of a stage.
template <typename Visit>
void visit_in_view(const Stage& stage, const Visit& visit) {
  const anim::AnimationSystem& system = stage.system();
  visit_in_tiles(stage.posed().selection().visible.size(), system.executor(), system.options().pus, visit);
}

// A thing in the air has no spot below it.
float contact_scale(const CharacterSource& source) {
  return source.roles.is_prop ? 0.0F : static_cast<float>(source.roles.size());
}

}  // namespace

void Picture::compose(const Stage& stage, Poses poses) {
  const Crowd& crowd = stage.crowd();
  if (colors_.size() < crowd.size()) {
    colors_.resize(crowd.size());
    put_away_.resize(crowd.size());
  }
  contact_scales_.clear();
  for (const CharacterSource& source : stage.characters()) contact_scales_.push_back(contact_scale(source));
  DrawnAgents drawn{.agents = placed_agents(crowd),
                    .outfits = crowd.looks().outfits,
                    .outfits_number = crowd.looks().number,
                    .contact_scales = contact_scales_,
                    .silhouettes_cast = stage.tuning().shadows};
  if (stage.selected() || stage.tuning().debug_view != DebugView::none || stage.tuning().plain_bodies) {
    color(stage, poses);
    drawn.colors = colors_;
  }
  if (!crowd.looks().in_hand.empty()) {
    put_things_away(stage);
    drawn.put_away = put_away_;
  }
  SortedDraws::compose(stage.posed(), stage.system(), drawn, poses);
}

void Picture::color(const Stage& stage, Poses poses) {
  const PosedCrowd& posed = stage.posed();
  const Tuning& tuning = stage.tuning();
  visit_in_view(stage, [&](std::size_t at) {
    const anim::VisibleAgent& agent = posed.selection().visible[at];
    const int mesh_lod = poses == Poses::exact ? 0 : posed.mesh_choice().lods()[at];
    colors_[at] = agent.agent == stage.selected()
                      ? selected_color
                      : debug_color(tuning, {.interval = agent.interval,
                                             .bone_level = posed.pose_of(agent.agent, poses).level(),
                                             .error_px = posed.error_meter().error_of(agent.agent),
                                             .mesh_lod = mesh_lod,
                                             .measure = posed.measures().of(agent.agent)});
  });
}

/// Finds the pieces of things that hands do not hold now.
void Picture::put_things_away(const Stage& stage) {
  const auto& visible = stage.posed().selection().visible;
  const Crowd& crowd = stage.crowd();
  const std::span<const std::uint16_t> in_hand = crowd.looks().in_hand;
  visit_in_view(stage, [&](std::size_t at) {
    const std::uint32_t agent = visible[at].agent;
    const bool shows =
        in_hand[agent] == render::Outfit::no_piece || stage.animated().details().held_arms().shows_thing(crowd, agent);
    put_away_[at] = shows ? render::Outfit::no_piece : in_hand[agent];
  });
}

}  // namespace throng::app
