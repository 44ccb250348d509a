// Streaming: characters are loaded on a thread, join a crowd that plays, and leave it again. So do clips.
#include <cstdio>
#include <future>
#include <vector>

#include "throng/throng.h"

using namespace throng;

namespace {

/// Poses all agents of the crowd for the next frame. This example does not draw them.
void step(Crowd& crowd, std::vector<PoseRequest>& requests) {
  requests.clear();
  for (const AgentId id : crowd.agents()) requests.push_back({.agent = id});
  crowd.advance(ticks_per_second / 60);
  crowd.update(requests);
}

/// Lets the last clip of the crowd's first character go, and takes it back from a file that has it alone.
Status stream_a_clip(Crowd& crowd, Character file) {
  const ClipId last{crowd.character(0).clip_count() - 1};
  for (std::uint32_t clip = 0; clip < last.number; ++clip) file = *file.without({clip});
  const auto less = crowd.character(0).without(last);
  if (!less) return less.error();
  if (const Status left = crowd.replace(0, *less); !left) return left;
  const auto more = less->with_clips(file);  // may take a moment, on any thread
  return more ? crowd.replace(0, *more) : more.error();
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) return std::fprintf(stderr, "usage: streaming MODEL...\n"), 2;
  const auto first = load(arguments[1]);
  if (!first) return std::fprintf(stderr, "%s\n", first.error().message.c_str()), 1;
  auto crowd = Crowd::create(first->characters.front(), {.pus = 2});
  if (!crowd) return std::fprintf(stderr, "%s\n", crowd.error().message.c_str()), 1;
  for (const AgentId id : crowd->add_agents(100)) crowd->agent(id).play({.clip = {0}});

  std::vector<PoseRequest> requests;
  int frames = 0;
  for (int round = 0; round < 4; ++round) {
    // Loading never touches the crowd, so it goes on meanwhile.
    const std::string path = arguments[1 + round % (count - 1)];
    auto loading = std::async(std::launch::async, [path] { return load(path); });
    while (loading.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      step(*crowd, requests);
      ++frames;
    }
    const auto loaded = loading.get();
    if (!loaded) return std::fprintf(stderr, "%s\n", loaded.error().message.c_str()), 1;
    const auto guest = crowd->add(loaded->characters.front());
    if (!guest) return std::fprintf(stderr, "%s\n", guest.error().message.c_str()), 1;

    std::vector<AgentId> guests;
    for (const AgentId id : crowd->add_agents(50, *guest)) guests.push_back(id);
    for (const AgentId id : guests) crowd->agent(id).play({.clip = {0}, .loop = true});
    for (int frame = 0; frame < 60; ++frame) step(*crowd, requests);
    for (const AgentId id : guests) crowd->remove_agent(id);
    const auto left = crowd->remove(*guest);  // its memory is free when no other owner has the character
    if (!left) return std::fprintf(stderr, "%s\n", left.error().message.c_str()), 1;
  }
  if (const Status streamed = stream_a_clip(*crowd, load(arguments[1])->characters.front()); !streamed)
    return std::fprintf(stderr, "%s\n", streamed.error().message.c_str()), 1;
  for (int frame = 0; frame < 60; ++frame) step(*crowd, requests);
  std::printf("4 characters and a clip came and went; %zu agents of the first play on\n", crowd->agents().size());
  return frames > 0 ? 0 : 1;
}
