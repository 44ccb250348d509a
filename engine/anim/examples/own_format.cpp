// A format of one's own: a reed of four bones is built of plain arrays, saved as a pack, and loaded again.
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "throng/throng.h"

using namespace throng;

namespace {

constexpr int keys = 31;  // a second at 30 Hz; the last repeats the first

/// Returns a turn about the z axis.
Quat turned(float radians) { return {.z = std::sin(0.5F * radians), .w = std::cos(0.5F * radians)}; }

/// Builds what a host has read of a file of its own: bones, one clip, a data key and a curve.
CharacterBuilder read_reed() {
  CharacterBuilder reed("reed");
  for (int bone = 0; bone < 4; ++bone) {
    const std::string name = "joint " + std::to_string(bone);
    reed.add_bone({.name = name, .parent = bone - 1, .rest = {.translation = {0.0F, bone == 0 ? 0.0F : 0.5F, 0.0F}}});
  }
  const int sway = reed.add_clip("sway", 1.0);
  std::vector<float> seconds, wind;
  for (int key = 0; key < keys; ++key) seconds.push_back(static_cast<float>(key) / (keys - 1));
  for (const float second : seconds) wind.push_back(std::sin(6.2831853F * second));
  for (int bone = 0; bone < 4; ++bone) {
    std::vector<Quat> turns;
    for (const float strength : wind) turns.push_back(turned(0.1F * strength));
    reed.set_rotations(sway, bone, {.seconds = seconds, .values = turns});
  }
  reed.add_data_key(sway, "rustle", 0.25);
  reed.add_curve(sway, "wind", seconds, wind);
  return reed;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return std::fprintf(stderr, "usage: own_format OUT.pack\n"), 2;
  const auto built = read_reed().build();
  if (!built) return std::fprintf(stderr, "%s\n", built.error().message.c_str()), 1;
  if (const Status saved = save(arguments[1], built->characters); !saved)
    return std::fprintf(stderr, "%s\n", saved.error().message.c_str()), 1;

  const auto loaded = load(arguments[1]);
  if (!loaded) return std::fprintf(stderr, "%s\n", loaded.error().message.c_str()), 1;
  const Character reed = loaded->characters.front();
  auto crowd = Crowd::create(reed);
  if (!crowd) return std::fprintf(stderr, "%s\n", crowd.error().message.c_str()), 1;
  const Agent agent = crowd->agent(crowd->add_agent());
  agent.play({.clip = reed.find_clip("sway")});
  int rustles = 0;
  for (int frame = 0; frame < 180; ++frame) {
    const Ticks before = crowd->clock();
    crowd->advance(ticks_per_second / 60);
    agent.motion().for_each_key(before, crowd->clock(), [&](const DataKey&) { ++rustles; });
  }
  std::printf("a reed of %d bones rustled %d times in 3 s\n", reed.bone_count(), rustles);
}
