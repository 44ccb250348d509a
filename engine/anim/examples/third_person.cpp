// A third-person character: gaits by speed, a gaze, feet on a slope, root motion and footsteps.
#include <chrono>
#include <cstdio>
#include <vector>

#include "throng/throng.h"

using namespace std::chrono_literals;
using namespace throng;

int main(int count, char** arguments) {
  if (count != 2) return std::fprintf(stderr, "usage: third_person MODEL\n"), 2;
  const auto file = load(arguments[1]);
  if (!file) return std::fprintf(stderr, "%s\n", file.error().message.c_str()), 1;
  const Character hero = file->characters.front();
  auto crowd = Crowd::create(hero);
  if (!crowd) return std::fprintf(stderr, "%s\n", crowd.error().message.c_str()), 1;
  const Agent agent = crowd->agent(crowd->add_agent());

  // Idle at 0, then each looping clip that goes somewhere, by its speed: feet keep step in between.
  std::vector<BlendPoint> gaits;
  if (const ClipId idle = hero.find_role("stand"); idle.valid()) gaits.push_back({.clip = idle});
  for (const char* name : {"walk", "jog", "run"}) {
    const ClipId clip = hero.find_role(name);
    const double speed = hero.clip(clip).ground_speed;
    const double last = gaits.empty() ? -1.0 : static_cast<double>(gaits.back().parameter);
    if (clip.valid() && speed > last) gaits.push_back({.clip = clip, .parameter = static_cast<float>(speed)});
  }
  if (gaits.empty())
    return std::fprintf(stderr, "no clip of the model is named as one to stand, walk, jog or run with\n"), 1;
  const auto legs = agent.add(BlendSpace{.points = gaits});
  const auto gaze = agent.add(LookAt{});         // an error where the character has no head that it knows
  const auto feet = agent.add(FootPlacement{});  // and no legs

  Place stand;  // where the character is in the world; it walks up a slope of 1 to 10
  int steps = 0;
  for (int frame = 0; frame < 600; ++frame) {
    const float ahead = gaits.back().parameter * (frame < 300 ? 0.5F : 1.0F);
    if (legs) agent.set_parameter(*legs, ahead);
    if (gaze && frame == 60) agent.processes().look_at(*gaze, {1.0F, 1.6F, 2.0F}, 300ms);
    const Ticks before = crowd->clock();
    crowd->advance(ticks_per_second / 60);
    const RootMotion moved = agent.motion().displacement(before, crowd->clock());
    const bool walks_in_place = moved.displacement.z == 0.0F;  // as the clips of many files do
    stand.position.z += walks_in_place ? ahead / 60.0F : moved.displacement.z;
    stand.position.y = 0.1F * stand.position.z;
    agent.motion().for_each_key(before, crowd->clock(), [&](const DataKey&) { ++steps; });
    if (feet) {  // in the pose that comes now, so after the clock has moved
      agent.processes().set_placement(*feet, stand);
      agent.processes().set_ground(*feet, -1, {0.0F, 0.0F, 0.0F}, {0.0F, 0.995037F, -0.0995037F});
    }
    const PoseRequest pose{.agent = agent.id()};  // no palette: this example does not draw
    crowd->update({&pose, 1});
  }
  std::printf("walked %.1f m in 10 s, %d data keys on the way\n", static_cast<double>(stand.position.z), steps);
}
