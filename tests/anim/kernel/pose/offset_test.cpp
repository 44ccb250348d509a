#include "engine/anim/kernel/pose/offset.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/anim/kernel/kernels.h"
#include "tests/anim/kernel/pose/random_packet.h"

namespace throng::anim::offset_test {
namespace {

constexpr float half_life = 0.1F;

struct alignas(64) Offset {
  float offsets[offset_components][packet_bones];
  float velocities[offset_components][packet_bones];
};

glm::dvec3 vector_at(const float (&rows)[offset_components][packet_bones], int first_row, int bone) {
  return {rows[first_row][bone], rows[first_row + 1][bone], rows[first_row + 2][bone]};
}

/// What was shown, now and before, and what is to be shown.
struct Change {
  Packet shown, shown_before, target, target_before;
};

Change random_change(unsigned seed) {
  return {random_packet(seed), random_packet(seed + 100), random_packet(seed + 200), random_packet(seed + 300)};
}

/// Everything moves a little in an update, as poses do.
Change moving_change(unsigned seed) {
  Change change = random_change(seed);
  for (int bone = 0; bone < packet_bones; ++bone) {
    const glm::dvec3 step = position_of(change.shown_before, bone) * 0.02;
    set_rotation(change.shown_before, bone, rotation_by(-step) * rotation_of(change.shown, bone));
    set_rotation(change.target_before, bone, rotation_by(step * 0.5) * rotation_of(change.target, bone));
    for (int component = 4; component < rigid_components; ++component) {
      change.shown_before.lanes[component][bone] = change.shown.lanes[component][bone] - 0.02F;
      change.target_before.lanes[component][bone] = change.target.lanes[component][bone] + 0.01F;
    }
  }
  return change;
}

Offset capture(const Kernels& kernels, const Change& change, float seconds, bool target_moves = true) {
  Offset offset{};
  kernels.capture_offset({.shown = change.shown.data(),
                          .shown_before = change.shown_before.data(),
                          .target = change.target.data(),
                          .target_before = target_moves ? change.target_before.data() : nullptr,
                          .seconds_between = seconds,
                          .offsets = offset.offsets[0],
                          .velocities = offset.velocities[0]});
  return offset;
}

Packet apply(const Kernels& kernels, const Packet& target, const Offset& offset, OffsetDecay decay,
             int components = general_components) {
  Packet out{};
  kernels.apply_offset({.target = target.data(),
                        .offsets = offset.offsets[0],
                        .velocities = offset.velocities[0],
                        .decay = decay,
                        .components = components,
                        .out = out.data()});
  return out;
}

glm::dvec3 cut(const glm::dvec3& v, double most) { return v * std::min(1.0, most / glm::length(v)); }

/// How far `shown` turned between two updates, in double precision, before it is cut to a sane velocity.
glm::dvec3 reference_turn(const Change& change, int bone, bool target_moves) {
  const Packet& target_before = target_moves ? change.target_before : change.target;
  glm::dquat now = rotation_of(change.shown, bone) * glm::conjugate(rotation_of(change.target, bone));
  const glm::dquat before = rotation_of(change.shown_before, bone) * glm::conjugate(rotation_of(target_before, bone));
  if (now.w < 0.0) now = -now;
  const double angle = 2.0 * std::acos(std::clamp(glm::dot(before, now) < 0.0 ? -before.w : before.w, -1.0, 1.0));
  const glm::dvec3 short_way = rotation_vector(before);
  const double short_angle = glm::length(short_way);
  const bool the_long_way = angle > std::numbers::pi;
  const glm::dvec3 continued = the_long_way ? short_way * (-angle / short_angle) : short_way;
  return rotation_vector(now) - continued;
}

TEST(OffsetCapture, AgreesWithDoublePrecisionOnEveryTarget) {
  for (const Kernels& kernels : runnable_kernels()) {
    SCOPED_TRACE(kernels.target);
    for (unsigned seed = 0; seed < 60; ++seed) {
      const bool target_moves = seed % 2 == 0;
      const Change change = seed % 3 == 0 ? random_change(seed) : moving_change(seed);
      constexpr float seconds = 0.0625F;
      const Offset offset = capture(kernels, change, seconds, target_moves);
      for (int bone = 0; bone < packet_bones; ++bone) {
        const glm::dquat turn = rotation_of(change.shown, bone) * glm::conjugate(rotation_of(change.target, bone));
        EXPECT_LT(glm::length(vector_at(offset.offsets, 0, bone) - rotation_vector(turn)), 1e-5);
        const glm::dvec3 move = position_of(change.shown, bone) - position_of(change.target, bone);
        EXPECT_LT(glm::length(vector_at(offset.offsets, 3, bone) - move), 1e-6);
        const double rate = 1.0 / static_cast<double>(seconds);
        const glm::dvec3 turning = cut(reference_turn(change, bone, target_moves) * rate, 20.0);
        EXPECT_LT(glm::length(vector_at(offset.velocities, 0, bone) - turning), 2e-5 * rate) << seed << " " << bone;
        const Packet& target_before = target_moves ? change.target_before : change.target;
        const glm::dvec3 move_before = position_of(change.shown_before, bone) - position_of(target_before, bone);
        EXPECT_LT(glm::length(vector_at(offset.velocities, 3, bone) - cut((move - move_before) * rate, 5.0)), 1e-5);
      }
    }
  }
}

TEST(OffsetCapture, MeasuresTurnsFromNothingToHalfATurn) {
  for (const Kernels& kernels : runnable_kernels()) {
    for (int step = 0; step <= 1000; ++step) {
      Change change{identity_packet(), identity_packet(), identity_packet(), identity_packet()};
      const double angle = 3.14159 * std::pow(step / 1000.0, 3.0);
      const glm::dvec3 turn = glm::normalize(glm::dvec3(0.3, -0.8, 0.5)) * angle;
      set_rotation(change.shown, 7, rotation_by(turn));
      set_rotation(change.shown, 8, -rotation_by(turn));
      const Offset offset = capture(kernels, change, 0.0F);
      EXPECT_LT(glm::length(vector_at(offset.offsets, 0, 7) - turn), 2e-6) << kernels.target << " " << angle;
      EXPECT_LT(glm::length(vector_at(offset.offsets, 0, 8) - turn), 2e-6) << kernels.target << " " << angle;
    }
  }
}

TEST(OffsetCapture, HasNoVelocityWithoutAPoseBefore) {
  for (const Kernels& kernels : runnable_kernels()) {
    const Change change = random_change(1);
    Offset offset = capture(kernels, change, 0.1F);
    kernels.capture_offset({.shown = change.shown.data(),
                            .target = change.target.data(),
                            .seconds_between = 0.1F,
                            .offsets = offset.offsets[0],
                            .velocities = offset.velocities[0]});
    const Offset stopped = capture(kernels, change, 0.0F);
    for (int component = 0; component < offset_components; ++component) {
      for (int bone = 0; bone < packet_bones; ++bone) {
        EXPECT_EQ(offset.velocities[component][bone], 0.0F) << kernels.target;
        EXPECT_EQ(stopped.velocities[component][bone], 0.0F) << kernels.target;
      }
    }
  }
}

TEST(OffsetApply, ShowsAtFirstWhatWasShownLast) {
  for (const Kernels& kernels : runnable_kernels()) {
    for (unsigned seed = 0; seed < 100; ++seed) {
      const Change change = random_change(seed);
      const Packet out = apply(kernels, change.target, capture(kernels, change, 0.02F), offset_decay(0.0F, half_life));
      for (int bone = 0; bone < packet_bones; ++bone) {
        const glm::dquat shown = rotation_of(change.shown, bone);
        const glm::dquat actual = rotation_of(out, bone);
        const double apart = std::min(glm::length(actual - shown), glm::length(actual + shown));
        EXPECT_LT(apart, 1e-6) << kernels.target << " " << seed << " " << bone;
        EXPECT_LT(glm::length(position_of(out, bone) - position_of(change.shown, bone)), 1e-6) << kernels.target;
        EXPECT_EQ(scale_of(out, bone), scale_of(change.target, bone)) << kernels.target;
      }
    }
  }
}

TEST(OffsetApply, AgreesWithDoublePrecisionOnEveryTarget) {
  for (const Kernels& kernels : runnable_kernels()) {
    for (unsigned seed = 0; seed < 40; ++seed) {
      const Change change = moving_change(seed);
      const Offset offset = capture(kernels, change, 0.02F);
      const OffsetDecay decay = offset_decay(static_cast<float>(seed) * 0.02F, half_life);
      const Packet out = apply(kernels, change.target, offset, decay);
      for (int bone = 0; bone < packet_bones; ++bone) {
        const auto left = [&](int row) {
          return vector_at(offset.offsets, row, bone) * static_cast<double>(decay.offset) +
                 vector_at(offset.velocities, row, bone) * static_cast<double>(decay.velocity);
        };
        const glm::dquat expected = rotation_by(cut(left(0), std::numbers::pi)) * rotation_of(change.target, bone);
        EXPECT_LT(angle_between(rotation_of(out, bone), expected), 5e-6) << kernels.target << " " << seed;
        EXPECT_NEAR(glm::length(rotation_of(out, bone)), 1.0, 1e-6) << kernels.target;
        EXPECT_LT(glm::length(position_of(out, bone) - position_of(change.target, bone) - left(3)), 1e-6);
      }
    }
  }
}

TEST(OffsetApply, GoesOnAsFastAsWhatWasShown) {
  constexpr float frame = 1.0F / 240.0F;
  for (const Kernels& kernels : runnable_kernels()) {
    Change change = random_change(4);
    change.target = change.shown;
    const glm::dvec3 step = glm::dvec3(0.3, -0.5, 0.2) * 0.02;
    for (int bone = 0; bone < packet_bones; ++bone) {
      set_rotation(change.target, bone, rotation_by({0.0, 0.6, 0.1}) * rotation_of(change.shown, bone));
      set_rotation(change.shown_before, bone, rotation_by(-step) * rotation_of(change.shown, bone));
    }
    const Offset offset = capture(kernels, change, frame, false);
    const Packet next = apply(kernels, change.target, offset, offset_decay(frame, 0.5F));
    for (int bone = 0; bone < packet_bones; ++bone) {
      const glm::dquat moved = rotation_of(next, bone) * glm::conjugate(rotation_of(change.shown, bone));
      EXPECT_LT(glm::length(rotation_vector(moved) - step), 0.15 * glm::length(step)) << kernels.target;
    }
  }
}

TEST(OffsetApply, NeverGoesFurtherThanItsHeaderSays) {
  for (const Kernels& kernels : runnable_kernels()) {
    for (unsigned seed = 0; seed < 8; ++seed) {
      const Change change = moving_change(seed);
      const Offset moving = capture(kernels, change, 0.01F);
      const Offset resting = capture(kernels, change, 0.0F);
      glm::dvec3 before[packet_bones];
      std::fill(std::begin(before), std::end(before), glm::dvec3(10.0));
      for (float t = 0.0F; t < 1.0F; t += 0.01F) {
        const Packet out = apply(kernels, change.target, moving, offset_decay(t, half_life));
        const Packet shrinking = apply(kernels, change.target, resting, offset_decay(t, half_life));
        for (int bone = 0; bone < packet_bones; ++bone) {
          const double turned = angle_between(rotation_of(change.target, bone), rotation_of(out, bone));
          EXPECT_LE(turned, glm::length(vector_at(moving.offsets, 0, bone)) +
                                0.022 * glm::length(vector_at(moving.velocities, 0, bone)) + 1e-5);
          const double moved = glm::length(position_of(out, bone) - position_of(change.target, bone));
          EXPECT_LE(moved, glm::length(vector_at(moving.offsets, 3, bone)) +
                               0.022 * glm::length(vector_at(moving.velocities, 3, bone)) + 1e-6);
          const glm::dvec3 left(angle_between(rotation_of(change.target, bone), rotation_of(shrinking, bone)),
                                glm::length(position_of(shrinking, bone) - position_of(change.target, bone)), 0.0);
          EXPECT_LT(left.x, before[bone].x + 2e-6) << kernels.target << " " << t;
          EXPECT_LT(left.y, before[bone].y + 1e-6) << kernels.target << " " << t;
          before[bone] = left;
        }
      }
    }
  }
}

TEST(OffsetApply, HasTheTargetsBitsOnceItHasEndedAndWhereNothingIsOff) {
  for (const Kernels& kernels : runnable_kernels()) {
    const Change change = random_change(3);
    const Offset offset = capture(kernels, change, 0.02F);
    EXPECT_EQ(bits(apply(kernels, change.target, offset, offset_decay(0.8F, half_life))), bits(change.target));

    const Change still{identity_packet(), identity_packet(), identity_packet(), identity_packet()};
    const Offset nothing = capture(kernels, still, 0.02F);
    EXPECT_EQ(bits(apply(kernels, still.target, nothing, offset_decay(0.01F, half_life))), bits(still.target));
  }
}

TEST(OffsetApply, MayWriteOverTheTargetAndDoesNotTouchWhatTheStateHasNot) {
  for (const Kernels& kernels : runnable_kernels()) {
    const Change change = random_change(5);
    const Offset offset = capture(kernels, change, 0.02F);
    const OffsetDecay decay = offset_decay(0.03F, half_life);
    Packet over = change.target;
    kernels.apply_offset({.target = over.data(),
                          .offsets = offset.offsets[0],
                          .velocities = offset.velocities[0],
                          .decay = decay,
                          .components = general_components,
                          .out = over.data()});
    EXPECT_EQ(bits(over), bits(apply(kernels, change.target, offset, decay))) << kernels.target;
    const Packet rigid = apply(kernels, change.target, offset, decay, rigid_components);
    for (int bone = 0; bone < packet_bones; ++bone) EXPECT_EQ(scale_of(rigid, bone), glm::dvec3(0.0));
  }
}

TEST(Offset, IsTheSameToTheBitAmongTargetsThatFuse) {
  const Change change = moving_change(6);
  const Offset best = capture(best_kernels(), change, 0.02F);
  const OffsetDecay decay = offset_decay(0.05F, half_life);
  for (const Kernels& kernels : runnable_kernels()) {
    if (kernels.fused_multiply_add != best_kernels().fused_multiply_add) continue;
    const Offset offset = capture(kernels, change, 0.02F);
    for (int component = 0; component < offset_components; ++component) {
      for (int bone = 0; bone < packet_bones; ++bone) {
        EXPECT_EQ(offset.offsets[component][bone], best.offsets[component][bone]) << kernels.target;
        EXPECT_EQ(offset.velocities[component][bone], best.velocities[component][bone]) << kernels.target;
      }
    }
    EXPECT_EQ(bits(apply(kernels, change.target, best, decay)), bits(apply(best_kernels(), change.target, best, decay)))
        << kernels.target;
  }
}

TEST(OffsetDecay, FollowsTheClosedForm) {
  for (const float life : {0.01F, 0.1F, 2.0F}) {
    for (int step = 0; step < 80; ++step) {
      const float t = life * 0.1F * static_cast<float>(step);
      const double y = 1.6783469900166605 / static_cast<double>(life);
      const double left = std::exp(-y * static_cast<double>(t));
      const OffsetDecay decay = offset_decay(t, life);
      EXPECT_NEAR(decay.offset, (1.0 + y * static_cast<double>(t)) * left, 1e-7) << t;
      EXPECT_NEAR(decay.velocity, static_cast<double>(t) * left, 1e-7 * static_cast<double>(life)) << t;
    }
  }
}

TEST(OffsetDecay, HalvesInAHalfLifeAndEndsAfterEight) {
  EXPECT_EQ(offset_decay(0.0F, 0.25F).offset, 1.0F);
  EXPECT_EQ(offset_decay(0.0F, 0.25F).velocity, 0.0F);
  EXPECT_NEAR(offset_decay(0.25F, 0.25F).offset, 0.5, 1e-6);
  EXPECT_GT(offset_decay(1.99F, 0.25F).offset, 0.0F);
  EXPECT_LT(offset_decay(1.99F, 0.25F).offset, 3e-5F);
  EXPECT_EQ(offset_decay(2.0F, 0.25F).offset, 0.0F);
  EXPECT_EQ(offset_decay(2.0F, 0.25F).velocity, 0.0F);
}

TEST(OffsetDecay, IsOverAtOnceWithoutAHalfLife) {
  EXPECT_EQ(offset_decay(0.0F, 0.0F).offset, 0.0F);
  EXPECT_EQ(offset_decay(0.0F, -1.0F).offset, 0.0F);
}

}  // namespace
}  // namespace throng::anim::offset_test
