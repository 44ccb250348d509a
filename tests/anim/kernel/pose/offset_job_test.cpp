#include <cmath>

#include <gtest/gtest.h>

#include "engine/anim/kernel/pose/offset.h"
#include "tests/anim/kernel/pose/random_packet.h"
#include "tests/anim/kernel/validity.h"

namespace throng::anim::offset_job_test {
namespace {

struct alignas(64) Offset {
  float offsets[offset_components][packet_bones];
  float velocities[offset_components][packet_bones];
};

TEST(OffsetCaptureJob, IsValidAsItsCommentsSay) {
  const Packet shown = random_packet(1), target = random_packet(2);
  Offset offset{};
  const OffsetCaptureJob job{.shown = shown.data(),
                             .shown_before = shown.data(),
                             .target = target.data(),
                             .target_before = target.data(),
                             .seconds_between = 0.01F,
                             .offsets = offset.offsets[0],
                             .velocities = offset.velocities[0]};
  expect_validity<OffsetCaptureJob>(
      job, {{false, "no shown", [](OffsetCaptureJob& job) { job.shown = nullptr; }},
            {false, "shown off the alignment", [](OffsetCaptureJob& job) { job.shown += 4; }},
            {false, "no target", [](OffsetCaptureJob& job) { job.target = nullptr; }},
            {false, "target off the alignment", [](OffsetCaptureJob& job) { job.target += 4; }},
            {false, "no offsets", [](OffsetCaptureJob& job) { job.offsets = nullptr; }},
            {false, "offsets off the alignment", [](OffsetCaptureJob& job) { job.offsets += 4; }},
            {false, "no velocities", [](OffsetCaptureJob& job) { job.velocities = nullptr; }},
            {false, "velocities off the alignment", [](OffsetCaptureJob& job) { job.velocities += 4; }},
            {true, "nothing shown before", [](OffsetCaptureJob& job) { job.shown_before = nullptr; }},
            {false, "shown before off the alignment", [](OffsetCaptureJob& job) { job.shown_before += 4; }},
            {true, "a target that rests", [](OffsetCaptureJob& job) { job.target_before = nullptr; }},
            {false, "target before off the alignment", [](OffsetCaptureJob& job) { job.target_before += 4; }},
            {true, "no time between", [](OffsetCaptureJob& job) { job.seconds_between = 0.0F; }},
            {false, "no number of seconds", [](OffsetCaptureJob& job) { job.seconds_between = std::nanf(""); }},
            {false, "offsets where velocities are", [](OffsetCaptureJob& job) { job.offsets = job.velocities + 16; }},
            {false, "velocities over an input", [](OffsetCaptureJob& job) { job.target = job.velocities; }}});
}

TEST(OffsetApplyJob, IsValidAsItsCommentsSay) {
  const Packet target = random_packet(1);
  const Offset offset{};
  Packet out{};
  const OffsetApplyJob job{.target = target.data(),
                           .offsets = offset.offsets[0],
                           .velocities = offset.velocities[0],
                           .decay = {0.5F, 0.1F},
                           .components = general_components,
                           .out = out.data()};
  expect_validity<OffsetApplyJob>(
      job, {{false, "no target", [](OffsetApplyJob& job) { job.target = nullptr; }},
            {false, "target off the alignment", [](OffsetApplyJob& job) { job.target += 4; }},
            {false, "no offsets", [](OffsetApplyJob& job) { job.offsets = nullptr; }},
            {false, "offsets off the alignment", [](OffsetApplyJob& job) { job.offsets += 4; }},
            {false, "no velocities", [](OffsetApplyJob& job) { job.velocities = nullptr; }},
            {false, "velocities off the alignment", [](OffsetApplyJob& job) { job.velocities += 4; }},
            {false, "no out", [](OffsetApplyJob& job) { job.out = nullptr; }},
            {false, "out off the alignment", [](OffsetApplyJob& job) { job.out += 4; }},
            {true, "an end", [](OffsetApplyJob& job) { job.decay = {}; }},
            {false, "an offset that grows", [](OffsetApplyJob& job) { job.decay.offset = 1.01F; }},
            {false, "a velocity backwards", [](OffsetApplyJob& job) { job.decay.velocity = -0.1F; }},
            {false, "a pose over its offsets", [](OffsetApplyJob& job) { job.offsets = job.out; }},
            {true, "rigid", [](OffsetApplyJob& job) { job.components = rigid_components; }},
            {false, "eight components", [](OffsetApplyJob& job) { job.components = 8; }}});
}

}  // namespace
}  // namespace throng::anim::offset_job_test
