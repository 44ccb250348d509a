#include <cstdio>

#include "throng/throng.h"

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const auto file = throng::load(arguments[1]);
  if (!file) return std::fprintf(stderr, "%s\n", file.error().message.c_str()), 1;
  auto crowd = throng::Crowd::create(file->characters.front(), {.pus = 2, .hash = true});
  if (!crowd) return std::fprintf(stderr, "%s\n", crowd.error().message.c_str()), 1;
  const throng::PoseRequest request{.agent = crowd->add_agent()};
  crowd->agent(request.agent).play({.clip = {1}});
  crowd->advance(throng::ticks_per_second / 60);
  crowd->update({&request, 1});
  std::printf("pose hash %016llx\n", static_cast<unsigned long long>(crowd->debug().pose_hash()));
}
