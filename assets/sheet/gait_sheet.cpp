// throng_gait_sheet FILE.png: how the built-in character goes at velocities between those of its clips, for people. A
// row a velocity, eight phases of the stride.

#include <array>
#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "app/character/gait_plane.h"
#include "assets/sheet/contact_sheet.h"
#include "assets/sheet/studio.h"
#include "engine/anim/agent/animation_system.h"
#include "engine/anim/agent/blend_space_2d_channel.h"

namespace throng::sheet {
namespace {

using Plane = std::shared_ptr<const anim::BlendSpace2d>;

constexpr int columns = 8;

/// Metres a second to the left and ahead.
constexpr std::array<glm::vec2, 11> velocities{{{0.0F, 0.2F},
                                                {0.0F, 0.5F},
                                                {0.0F, 0.9F},
                                                {0.0F, 1.8F},
                                                {0.0F, 3.0F},
                                                {0.3F, 0.0F},
                                                {-0.6F, 0.0F},
                                                {0.0F, -0.4F},
                                                {0.4F, 0.4F},
                                                {-0.3F, -0.3F},
                                                {0.2F, 1.0F}}};

/// Returns the seconds that a left and a right step take together.
double cycle_seconds(const app::CharacterSource& source, const Plane& plane, const glm::vec2& velocity) {
  glm::dvec2 stride(0.0);
  const anim::BlendPlane::Shares shares = plane->plane().shares(velocity);
  for (const anim::BlendPlane::Share& share : shares.all()) {
    const anim::BlendPoint2d& point = plane->point(share.point);
    const double seconds = to_seconds(source.character->clips[static_cast<std::size_t>(point.clip)].duration);
    stride += glm::dvec2(point.place) * (static_cast<double>(share.weight) * seconds);
  }
  return glm::length(stride) / static_cast<double>(glm::length(velocity));
}

render::Image phases_of(Studio& studio, const Plane& plane, const glm::vec2& velocity) {
  constexpr float pitch = 1.35F;
  const app::CharacterSource& source = studio.character();
  const auto system = std::move(*anim::AnimationSystem::create(source.character, {}));
  system->set_agent_count(1);
  if (!system->agent(0).add_channel(std::make_unique<anim::BlendSpace2dChannel>(plane, velocity))) return {};
  const Ticks step = to_ticks(cycle_seconds(source, plane, velocity) / columns);
  Random random(12, 0);
  const app::Tints clothes = app::random_tints(random);
  std::vector<Figure> figures;
  for (int column = 0; column < columns; ++column) {
    Figure& figure = figures.emplace_back();
    figure.palette.resize(source.model.skeleton.palette.size());
    figure.place.x = (static_cast<float>(column) - 0.5F * (columns - 1)) * pitch;
    figure.heading = velocity.x == 0.0F ? 1.1F : 0.4F;
    figure.tints = clothes;
    const PoseRequest update{.agent = {0}};
    const anim::ExactPose wanted{.agent = {0}, .palette = figure.palette.data()};
    system->update({&update, 1});
    system->pose_exactly({&wanted, 1});
    system->advance(step);
  }
  return studio.take({.width = 1000, .height = 220, .metres = 2.36F, .centre = {0.0F, 1.12F, 0.0F}, .shadows = false},
                     figures);
}

int write_sheet(Studio& studio, const char* file) {
  const app::CharacterSource& source = studio.character();
  const auto plane = app::gait_plane(source.roles, static_cast<int>(source.clip_names.size()), app::Middle::steps);
  if (!plane) return 1;
  ContactSheet sheet;
  for (const glm::vec2& velocity : velocities) sheet.add(phases_of(studio, *plane, velocity));
  return sheet.write(file) ? 0 : 1;
}

}  // namespace
}  // namespace throng::sheet

int main(int argument_count, char** arguments) {
  if (argument_count != 2) {
    std::fputs("throng_gait_sheet: usage: throng_gait_sheet FILE.png\n", stderr);
    return 2;
  }
  const auto studio = throng::sheet::Studio::open();
  return studio ? throng::sheet::write_sheet(*studio, arguments[1]) : 1;
}
