// A process that has a crowd forks, as pre-forking servers and multiprocessing of Python do: the child has its memory
// and none of its threads.

#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "throng/c.h"

#include "engine/anim/base/aligned_bytes.h"
#include "tests/anim/agent/heard_misuses.h"
#include "tests/api/api_crowd.h"

// The thread sanitizer lets a child start threads only if it is asked to.
extern "C" const char* __tsan_default_options();                                // NOLINT: its name
extern "C" const char* __tsan_default_options() { return "die_after_fork=0"; }  // NOLINT: its name

namespace throng::fork_test {
namespace {

using anim::HeardMisuses;
using api_test::ApiCrowd;
using api_test::mannequin;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::uint32_t many = 200;  // agents that are worth waking several PUs for
constexpr int pus = 4;

/// Returns whether a child that calls `does` ends well and says that all was as it should be. It has a minute.
template <typename Does>
bool holds_in_child(Does&& does) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(60);
    _exit(does() ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_FALSE(WIFSIGNALED(status)) << "signal " << WTERMSIG(status);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void play(ApiCrowd& crowd) {
  for (std::uint32_t agent = 0; agent < many; ++agent) {
    crowd.agent(agent).play({.clip = {agent % mannequin().clip_count()}});
  }
  crowd.step();
}

TEST(ApiFork, AChildIsToldThatItHasNoThreadsOfItsParentsCrowd) {
  const HeardMisuses heard;
  ApiCrowd crowd(many, {.pus = pus});
  play(crowd);
  const std::uint64_t hash = crowd.hash();
  const std::vector<Vec3> positions(many);
  EXPECT_TRUE(holds_in_child([&] {
    crowd.step();
    Lod lod;
    const bool selects = lod.select(*crowd, {.positions = positions}).size() == many;
    return selects && crowd.hash() == hash &&
           testing::Value(HeardMisuses::all(), ElementsAre(HasSubstr("Crowd::update: its threads are in")));
  }));
  crowd.step();
  EXPECT_NE(crowd.hash(), hash) << "the parent goes on";
  EXPECT_TRUE(HeardMisuses::all().empty());
}

TEST(ApiFork, AChildDestroysACrowdOfItsParent) {
  std::optional<ApiCrowd> crowd(std::in_place, many, CrowdOptions{.pus = pus});
  play(*crowd);
  EXPECT_TRUE(holds_in_child([&] {
    crowd.reset();
    return true;
  }));
}

TEST(ApiFork, AChildMakesCrowdsOfItsOwn) {
  ApiCrowd crowd(many, {.pus = pus});
  play(crowd);
  EXPECT_TRUE(holds_in_child([&] {
    ApiCrowd own(many, {.pus = pus});
    play(own);
    return own.hash() == crowd.hash();
  }));
}

TEST(ApiFork, AChildThatConfiguresACrowdOfItsParentGoesOnWithIt) {
  ApiCrowd crowd(many, {.pus = pus}), twin(many, {.pus = pus});
  play(crowd);
  play(twin);
  twin.step(3);
  EXPECT_TRUE(holds_in_child([&] {
    if (!crowd->configure({.pus = pus, .hash = true})) return false;
    crowd.step(3);
    return crowd.hash() == twin.hash();
  }));
}

TEST(ApiFork, AChildGoesOnWithACrowdThatHasNoThreads) {
  ApiCrowd crowd(many), twin(many);
  play(crowd);
  play(twin);
  twin.step(3);
  EXPECT_TRUE(holds_in_child([&] {
    crowd.step(3);
    return crowd.hash() == twin.hash();
  }));
}

/// A crowd of C that plays.
throng_crowd* crowd_of_c(const throng_character* character) {
  throng_crowd_options options = throng_crowd_options_default();
  options.pus = pus;
  throng_crowd* const crowd = throng_crowd_create(character, &options);
  std::vector<throng_id> ids(many);
  throng_crowd_add_agents(crowd, {0, THRONG_NONE}, many, ids.data());
  throng_play walk = throng_play_default();
  walk.clip = 1;
  for (const throng_id id : ids) throng_agent_play(crowd, id, &walk);
  return crowd;
}

TEST(ApiFork, AChildHearsTheSameThroughC) {
  throng_set_misuse_hook([](const char*, const char*, void*) {}, nullptr);
  throng_file* const file = throng_load(THRONG_SOURCE_DIR "/assets/mannequin.glb", 0.0);
  throng_character* const character = throng_file_character(file, 0);
  throng_crowd* const crowd = crowd_of_c(character);
  const std::uint32_t stride = throng_crowd_palette_bytes(crowd, {0, THRONG_NONE});
  const std::size_t bytes = std::size_t{many} * stride;
  const anim::AlignedBytes palettes = anim::allocate_aligned(bytes);
  const auto poses = [&](throng_crowd* posed) {
    return throng_crowd_update_all(posed, reinterpret_cast<float*>(palettes.get()), bytes, stride) == 0;
  };
  EXPECT_TRUE(poses(crowd));
  EXPECT_TRUE(holds_in_child([&] {
    const bool refused = !poses(crowd) && std::string(throng_last_error()).find("forked") != std::string::npos;
    throng_crowd_free(crowd);
    throng_crowd* const own = crowd_of_c(character);
    const bool posed = poses(own);
    throng_crowd_free(own);
    return refused && posed;
  }));
  throng_crowd_free(crowd);
  throng_character_free(character);
  throng_file_free(file);
  throng_set_misuse_hook(nullptr, nullptr);
}

}  // namespace
}  // namespace throng::fork_test
