// Tells how far feet slip where a recorded crowd is followed, and how far those of a loop that only follows the root.
//
//     throng_foot_slip FILE [SECONDS [START]]     of each of the three ways, steps and slips in millimetres
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>

#include "app/character/source.h"
#include "engine/tracks/read.h"
#include "tests/app/show/stage/foot_slips.h"

namespace throng::app {
namespace {

constexpr Ticks frame = ticks_per_second / 60;

CharacterSource person() {
  auto character = load_character(THRONG_SOURCE_DIR "/assets/mannequin.glb", "mannequin");
  if (!character) std::abort();
  return std::move(*character);
}

/// Walks at the pace of the clip whatever the file says, as a plain loop does.
CharacterSource plain_loop() {
  CharacterSource source = person();
  RoleClips& clips = source.roles.clips;
  clips[index_of(Role::stand)] = clips[index_of(Role::walk)];
  for (const Role role : {Role::walk, Role::jog, Role::run, Role::look_around}) clips[index_of(role)] = no_clip;
  return source;
}

struct Asked {
  std::shared_ptr<const Trajectories> crowd;
  double seconds = 30.0, start = 0.0;
};

bool print_slips(const char* name, CharacterSource source, bool placed_feet, const Asked& asked) {
  KeptPages pages;
  FootSlips slips(source.character->skeleton);
  const Tuning tuning{.scene = Scene::tracks,
                      .placed_feet = placed_feet,
                      .lod = {.rule = LodRule::off, .bone_lod = false, .smooth = false},
                      .system = {.pus = 2}};
  std::vector<CharacterSource> characters;
  characters.push_back(std::move(source));
  auto stage = Stage::create(std::move(characters), tuning, pages, 0, asked.crowd);
  if (!stage) return std::fprintf(stderr, "%s\n", stage.error().message.c_str()), false;
  TrackClock clock = (*stage)->crowd().tracks()->clock();
  clock.seconds += asked.start;
  (*stage)->set_track_clock(clock);
  const render::Camera everywhere{
      .position = {0.0F, 900.0F, 0.0F}, .yaw = 0.0F, .pitch = -1.57F, .vertical_view = 2.0F};
  const auto frames = static_cast<std::uint64_t>(asked.seconds * 60.0);
  for (std::uint64_t i = 0; i < frames; ++i) {
    (*stage)->move(frame);
    (*stage)->pose(everywhere, 1280, 720, frame, i);
    slips.add_frame(**stage, pages, to_seconds(frame));
  }
  const std::vector<double> all = slips.slips();
  std::printf("%-28s %6zu steps   median %7.2f   p95 %7.2f   largest %7.2f mm\n", name, all.size(), slip_at(all, 0.5),
              slip_at(all, 0.95), all.empty() ? 0.0 : all.back());
  return true;
}

}  // namespace
}  // namespace throng::app

int main(int argument_count, char** arguments) {
  using namespace throng;
  using namespace throng::app;
  if (argument_count < 2) return std::fputs("throng_foot_slip FILE [SECONDS [START]]\n", stderr), 2;
  TrackReading reading;
  auto read = read_trajectories(arguments[1], reading);
  if (!read) return std::fprintf(stderr, "%s\n", read.error().message.c_str()), 1;
  Asked asked{.crowd = std::make_shared<const Trajectories>(std::move(*read))};
  if (argument_count > 2) asked.seconds = std::strtod(arguments[2], nullptr);
  if (argument_count > 3) asked.start = std::strtod(arguments[3], nullptr);
  const bool all = print_slips("gaits by speed, feet placed", person(), true, asked) &&
                   print_slips("gaits by speed", person(), false, asked) &&
                   print_slips("a loop that follows the root", plain_loop(), false, asked);
  return all ? 0 : 1;
}
