// A server without drawing: where are the hands of a thousand players, whom nobody sees?
#include <cstdio>
#include <vector>

#include "throng/throng.h"

using namespace throng;

int main(int count, char** arguments) {
  if (count != 2) return std::fprintf(stderr, "usage: server MODEL\n"), 2;
  const auto file = load(arguments[1]);
  if (!file) return std::fprintf(stderr, "%s\n", file.error().message.c_str()), 1;
  const Character player = file->characters.front();
  auto crowd = Crowd::create(player, {.pus = 2});
  if (!crowd) return std::fprintf(stderr, "%s\n", crowd.error().message.c_str()), 1;

  // The last bone of the skeleton stands for a hand where the model names none.
  const int hand = player.find_bone("hand.R").value_or(player.bone_count() - 1);
  std::vector<ProcessId> sockets;
  std::vector<PoseRequest> requests;
  for (const AgentId id : crowd->add_agents(1000)) {
    const Agent agent = crowd->agent(id);
    agent.play({.clip = {id.number % player.clip_count()}});
    const auto socket = agent.add(Socket{.bone = hand});
    if (!socket) return std::fprintf(stderr, "%s\n", socket.error().message.c_str()), 1;
    sockets.push_back(*socket);
    requests.push_back({.agent = id});
  }

  for (int tick = 0; tick < 30; ++tick) {  // 30 Hz
    crowd->advance(ticks_per_second / 30);
    crowd->update(requests);
  }
  float highest = 0.0F;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const Place place = crowd->agent(requests[i].agent).processes().socket(sockets[i]);
    highest = place.position.y > highest ? place.position.y : highest;
  }
  std::printf("the highest of 1000 hands (%.*s) is at %.2f m\n", static_cast<int>(player.bone_name(hand).size()),
              player.bone_name(hand).data(), static_cast<double>(highest));
}
