// Things in hands: an update writes where the hand is beside the palette, and each thing is one more instance.
#include <cmath>
#include <cstdio>
#include <vector>

#include "throng/throng.h"

using namespace throng;

namespace {

/// Three rows of four, as JointFormat::matrices writes them and as an instanced draw reads them.
struct alignas(64) Matrix {
  float m[3][4];
  float unused[4];  // each agent's joint has a cache line of its own
};

/// Says where an agent stands and which way it faces.
struct Standing {
  float x, z, heading;
};

/// Returns the matrix of what a hand holds: the agent's place, times the hand's joint in model space.
Matrix instance_of(const Standing& agent, const Matrix& hand) {
  const float c = std::cos(agent.heading), s = std::sin(agent.heading);
  Matrix out{};
  for (int column = 0; column < 4; ++column) {
    out.m[0][column] = c * hand.m[0][column] + s * hand.m[2][column];
    out.m[1][column] = hand.m[1][column];
    out.m[2][column] = c * hand.m[2][column] - s * hand.m[0][column];
  }
  out.m[0][3] += agent.x;
  out.m[2][3] += agent.z;
  return out;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return std::fprintf(stderr, "usage: things_in_hands MODEL\n"), 2;
  const auto file = load(arguments[1]);
  if (!file) return std::fprintf(stderr, "%s\n", file.error().message.c_str()), 1;
  const Character person = file->characters.front();
  auto crowd = Crowd::create(person);
  if (!crowd) return std::fprintf(stderr, "%s\n", crowd.error().message.c_str()), 1;

  // At every bone level the joint is where the skin has it. An agent without a thing passes no place for its joints.
  const int hand[] = {person.find_bone("hand.R").value_or(person.bone_count() - 1)};
  const auto listed = crowd->write_joints(0, {.bones = hand, .format = JointFormat::matrices});
  if (!listed) return std::fprintf(stderr, "%s\n", listed.error().message.c_str()), 1;

  const std::span<const AgentId> people = crowd->add_agents(100);
  std::vector<Matrix> hands(people.size()), things(people.size());
  std::vector<Standing> standing(people.size());
  std::vector<PoseRequest> requests;
  const ClipId walk = person.find_role("walk");
  for (const AgentId id : people) {
    const auto i = static_cast<std::size_t>(id.number);
    standing[i] = {0.8F * static_cast<float>(i % 10), 0.8F * static_cast<float>(i / 10), static_cast<float>(i)};
    crowd->agent(id).play({.clip = walk.valid() ? walk : ClipId{0}, .start = Ticks{static_cast<long>(i) * 100'000}});
    requests.push_back({.agent = id, .joints = reinterpret_cast<std::byte*>(&hands[i])});  // .palette: what is drawn
  }
  float lowest = 1e9F;
  for (int frame = 0; frame < 60; ++frame) {
    crowd->advance(ticks_per_second / 60);
    crowd->update(requests);
    for (std::size_t i = 0; i < things.size(); ++i) {
      things[i] = instance_of(standing[i], hands[i]);                  // one draw of all things reads these
      const float tip = things[i].m[1][3] + 0.9F * things[i].m[1][1];  // 0.9 m along the joint's own y
      lowest = tip < lowest ? tip : lowest;
    }
  }
  std::printf("%zu things in hands; the lowest end was at %.2f m\n", things.size(), static_cast<double>(lowest));
}
