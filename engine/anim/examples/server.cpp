// A server without drawing: where are the hands and heads of a thousand players that are not seen?
#include <cstdio>
#include <vector>

#include "throng/throng.h"

using namespace throng;

namespace {

/// A joint as JointFormat::transforms writes it.
struct alignas(32) Joint {
  Quat rotation;
  Vec3 position;
  float scale;
};

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return std::fprintf(stderr, "usage: server MODEL\n"), 2;
  const auto file = load(arguments[1]);
  if (!file) return std::fprintf(stderr, "%s\n", file.error().message.c_str()), 1;
  const Character player = file->characters.front();
  auto crowd = Crowd::create(player, {.pus = 2});
  if (!crowd) return std::fprintf(stderr, "%s\n", crowd.error().message.c_str()), 1;

  // Only what these joints need is posed. The last bone stands for one that the model does not name so.
  const int last = player.bone_count() - 1;
  const int bones[] = {player.find_bone("hand.R").value_or(last), player.find_bone("head").value_or(last)};
  const auto listed = crowd->write_joints(0, {.bones = bones});
  if (!listed) return std::fprintf(stderr, "%s\n", listed.error().message.c_str()), 1;

  const std::span<const AgentId> players = crowd->add_agents(1000);
  std::vector<Joint> joints(players.size() * std::size(bones));
  std::vector<PoseRequest> requests;
  for (const AgentId id : players) {
    crowd->agent(id).play({.clip = {id.number % player.clip_count()}});
    requests.push_back({.agent = id, .joints = reinterpret_cast<std::byte*>(&joints[id.number * std::size(bones)])});
  }
  float highest = 0.0F;
  for (int tick = 0; tick < 30; ++tick) {  // 30 Hz
    crowd->advance(ticks_per_second / 30);
    crowd->update(requests);
    for (std::size_t hand = 0; hand < joints.size(); hand += std::size(bones)) {
      highest = joints[hand].position.y > highest ? joints[hand].position.y : highest;
    }
  }
  std::printf("the highest of 1000 hands (%.*s) was at %.2f m\n", static_cast<int>(player.bone_name(bones[0]).size()),
              player.bone_name(bones[0]).data(), static_cast<double>(highest));
}
