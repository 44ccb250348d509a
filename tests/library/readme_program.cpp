#include <cstdio>
#include <vector>

#include <throng/throng.h>

using namespace throng;

int main(int argument_count, char** arguments) {
  if (argument_count != 2) return 2;
  const auto file = load(arguments[1]);  // a .glb, a .gltf, or what `throng bake` made of them
  if (!file) return std::fprintf(stderr, "%s\n", file.error().message.c_str()), 1;
  const Character character = file->characters.front();
  auto created = Crowd::create(character, {.pus = 2, .hash = true});
  if (!created) return std::fprintf(stderr, "%s\n", created.error().message.c_str()), 1;
  Crowd& crowd = *created;
  const std::span<const AgentId> agents = crowd.add_agents(1000);
  for (const AgentId id : agents) crowd.agent(id).play({.clip = {id.number % character.clip_count()}});

  // A palette an agent, each on cache lines of its own, as far apart as they are written fastest.
  struct alignas(64) Line {
    float floats[16];
  };
  const std::size_t lines = crowd.palette_bytes(0) / sizeof(Line);
  std::vector<Line> palettes(lines * crowd.number_limit());

  std::vector<PoseRequest> requests;
  for (const AgentId id : agents)
    requests.push_back({.agent = id, .palette = reinterpret_cast<std::byte*>(&palettes[id.number * lines])});
  for (int number = 0; number < 60; ++number) {
    crowd.advance(ticks_per_second / 60);
    crowd.update(requests);  // returns when every palette is written
  }
  std::printf("pose hash %016llx\n", static_cast<unsigned long long>(crowd.debug().pose_hash()));
}
