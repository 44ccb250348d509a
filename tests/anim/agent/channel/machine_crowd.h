#pragma once

#include <memory>

#include <gtest/gtest.h>

#include "engine/anim/agent/channel/state_machine_channel.h"
#include "tests/anim/agent/crowd_rig.h"

/// A crowd of one agent that plays a state machine.
namespace throng::anim::machine_crowd {

using Kind = MachineDescription::Input::Kind;

inline constexpr ChannelId first{0};
inline constexpr double fade = 0.2;
inline constexpr int fade_frames = 12;
enum Input : std::uint32_t { speed, hurt, jump };
enum State : std::uint32_t { move, leap, fall, lie };

/// Moves by speed, leaps when told and lands by itself, falls when hurt and lies after that.
inline MachineDescription description() {
  return {.inputs = {{.name = "speed"}, {.name = "hurt", .kind = Kind::flag}, {.name = "jump", .kind = Kind::trigger}},
          .states =
              {{.name = "move", .by = {"speed"}, .points = {{"clip_0", {0.0}}, {"clip_1", {2.0}}}, .meaning = "plain"},
               {.name = "leap", .clip = "clip_2", .loop = false},
               {.name = "fall", .clip = "clip_3"},
               {.name = "lie", .clip = "clip_4", .speed = 0.5}},
          .transitions = {{.from = "move", .to = "leap", .when = {"jump"}, .fade = fade},
                          {.from = "leap", .to = "move", .at_end = true, .fade = fade},
                          {.from = "fall", .to = "lie", .after = 0.75, .fade = fade},
                          {.from = "lie", .to = "move", .when = {"not hurt"}, .at_end = true, .fade = fade},
                          {.from = "move", .to = "fall", .when = {"hurt"}, .fade = fade},
                          {.from = "leap", .to = "fall", .when = {"hurt"}, .fade = fade}}};
}

inline std::shared_ptr<const StateMachine> machine_of(const MachineDescription& from) {
  const auto made = StateMachine::create(from, *test_character());
  EXPECT_TRUE(made) << made.error().message;
  return *made;
}

/// One agent that plays a machine.
struct MachineCrowd : CrowdRig {
  explicit MachineCrowd(const MachineDescription& from = description(), const SystemOptions& options = {})
      : CrowdRig(options) {
    EXPECT_TRUE(system->agent(0).add_channel(std::make_unique<StateMachineChannel>(machine_of(from))));
  }
  void set(std::uint32_t input, float value = 1.0F) {
    const auto change = [&](StateMachineChannel& own) { own.set(input, value); };
    EXPECT_TRUE(system->agent(0).change<StateMachineChannel>(first, change));
  }
  const StateMachineChannel& channel() const { return *system->agent(0).channel<StateMachineChannel>(first); }
  std::uint32_t current() const { return channel().current(); }
};

inline Ticks duration_of(int clip) { return test_character()->clips[static_cast<std::size_t>(clip)].duration; }

/// Returns the frames until a time has passed.
inline int frames_to(Ticks time) { return static_cast<int>((time + frame_ticks - Ticks{1}) / frame_ticks); }

}  // namespace throng::anim::machine_crowd
