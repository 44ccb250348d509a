// A procedural motion: a step of one's own that sways the upper body, with a memory for each agent.
#include <cmath>
#include <cstdio>
#include <vector>

#include "throng/throng.h"

using namespace throng;

namespace {

/// All agents share the bones that sway.
struct Swaying {
  std::vector<int> bones;
};

/// Each agent remembers its time in plain bytes, 0 at first. The library moves them, and keeps them in snapshots.
struct Memory {
  double seconds;
};

/// Runs on a PU, beside others: it changes this pose and this memory, and neither allocates nor locks.
void sway(const StepJob& job) {
  auto& memory = *reinterpret_cast<Memory*>(job.memory);
  memory.seconds += to_seconds(job.delta);
  const auto half = static_cast<float>(0.1 * std::sin(3.0 * memory.seconds));
  for (const int bone : static_cast<const Swaying*>(job.shared)->bones) {
    // Rotations are relative to the bind pose, so this one turns about the axis that points ahead in model space.
    const Quat q = job.pose.rotation(bone);
    const float s = std::sin(half), c = std::cos(half);
    job.pose.set_rotation(bone, {c * q.x - s * q.y, c * q.y + s * q.x, c * q.z + s * q.w, c * q.w - s * q.z});
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return std::fprintf(stderr, "usage: own_step MODEL\n"), 2;
  const auto file = load(arguments[1]);
  if (!file) return std::fprintf(stderr, "%s\n", file.error().message.c_str()), 1;
  const Character character = file->characters.front();
  auto crowd = Crowd::create(character, {.hash = true});
  if (!crowd) return std::fprintf(stderr, "%s\n", crowd.error().message.c_str()), 1;

  const Swaying swaying{.bones = {1, 2}};
  const auto step =
      crowd->add_step(0, {.name = "sway", .memory_bytes = sizeof(Memory), .run = sway, .shared = &swaying});
  if (!step) return std::fprintf(stderr, "%s\n", step.error().message.c_str()), 1;
  std::vector<PoseRequest> requests;
  for (const AgentId id : crowd->add_agents(100)) {
    crowd->agent(id).play({.clip = {0}});
    const auto added = crowd->agent(id).add(*step);
    if (!added) return std::fprintf(stderr, "%s\n", added.error().message.c_str()), 1;
    requests.push_back({.agent = id});
  }
  for (int frame = 0; frame < 120; ++frame) {
    crowd->advance(ticks_per_second / 60);
    crowd->update(requests);
  }
  std::printf("100 agents sway for two seconds: %016llx\n",
              static_cast<unsigned long long>(crowd->debug().pose_hash()));
}
