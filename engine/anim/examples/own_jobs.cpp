// A host's own job system: it runs the PUs through one function, and poses stay the same to the bit.
#include <cstdio>
#include <thread>
#include <vector>

#include "throng/throng.h"

namespace {

/// Stands for the job system of an engine: it starts a thread for each job but the first.
class ThreadForEach final : public throng::Executor {
 public:
  void run(int count, throng::Job job) override {
    std::vector<std::thread> threads;
    for (int index = 1; index < count; ++index) threads.emplace_back(job.run, job.context, index);
    job.run(job.context, 0);
    for (std::thread& thread : threads) thread.join();
  }
};

/// Poses two hundred agents for a second, and returns the hash of all that was written.
std::uint64_t hash_of(const throng::Character& character, throng::Executor* executor) {
  auto crowd = throng::Crowd::create(character, {.pus = 2, .executor = executor, .hash = true});
  if (!crowd) return 0;
  std::vector<throng::PoseRequest> requests;
  for (const throng::AgentId id : crowd->add_agents(200)) {
    crowd->agent(id).play({.clip = {id.number % character.clip_count()}});
    requests.push_back({.agent = id});
  }
  for (int frame = 0; frame < 60; ++frame) {
    crowd->advance(throng::ticks_per_second / 60);
    crowd->update(requests);
  }
  return crowd->debug().pose_hash();
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return std::fprintf(stderr, "usage: own_jobs MODEL\n"), 2;
  const auto file = throng::load(arguments[1]);
  if (!file) return std::fprintf(stderr, "%s\n", file.error().message.c_str()), 1;

  ThreadForEach jobs;
  const std::uint64_t ours = hash_of(file->characters.front(), nullptr);
  const std::uint64_t theirs = hash_of(file->characters.front(), &jobs);
  std::printf("%s: %016llx\n", ours == theirs ? "the same poses" : "other poses",
              static_cast<unsigned long long>(theirs));
  return ours == theirs ? 0 : 1;
}
