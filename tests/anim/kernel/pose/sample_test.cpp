#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include "engine/anim/kernel/kernels.h"
#include "tests/anim/bake/sampled_rows.h"
#include "tests/anim/kernel/validity.h"

namespace throng::anim::sample_test {
namespace {

using namespace sampled_rows;

struct alignas(64) Packet {
  float lanes[general_components][packet_bones];
};

using Bits = std::array<std::uint32_t, sizeof(Packet) / 4>;
Bits bits(const Packet& packet) { return std::bit_cast<Bits>(packet); }

Packet sample(const Kernels& kernels, const SampledStream& stream, Ticks time, int packet) {
  Packet out{};
  SampleJob job;
  job.stream = &stream;
  job.point = locate(stream, time);
  job.packet = packet;
  job.pose = out.lanes[0];
  kernels.sample(job);
  return out;
}

/// What the rows mean at a time: normalised linear interpolation in double.
double expected_lane(const SampledRows& rows, int from, double fraction, int packet, int component, int lane) {
  const auto at = [&](int row, int c) { return static_cast<double>(row_value(rows, row, packet, c, lane)); };
  const int to = std::min(from + 1, rows.row_count - 1);
  const auto mixed = [&](int c, double sign) { return at(from, c) * (1.0 - fraction) + sign * at(to, c) * fraction; };
  if (component >= 4) return mixed(component, 1.0);
  double dot = 0.0;
  for (int axis = 0; axis < 4; ++axis) dot += at(from, axis) * at(to, axis);
  const double sign = dot < 0.0 ? -1.0 : 1.0;
  double length = 0.0;
  for (int axis = 0; axis < 4; ++axis) length += mixed(axis, sign) * mixed(axis, sign);
  return mixed(component, sign) / std::sqrt(length);
}

class Sample : public ::testing::TestWithParam<int> {
 protected:
  const SampledRows rows_ = wavy_rows(37, GetParam(), 9);
  const StreamBlock block_ = StreamBlock(rows_);
};

TEST(SampleJob, IsValidAsItsCommentsSay) {
  const StreamBlock block(wavy_rows(37, rigid_components, 9));
  Packet out{};
  const SampleJob job{
      .stream = &block.stream(), .point = locate(block.stream(), Ticks{}), .packet = 1, .pose = out.lanes[0]};
  expect_validity<SampleJob>(job, {{false, "no stream", [](SampleJob& job) { job.stream = nullptr; }},
                                   {false, "no row", [](SampleJob& job) { job.point.from = nullptr; }},
                                   {false, "a row off the alignment", [](SampleJob& job) { job.point.to += 4; }},
                                   {false, "weights of more than 1", [](SampleJob& job) { job.point.weights += 1; }},
                                   {false, "a negative packet", [](SampleJob& job) { job.packet = -1; }},
                                   {true, "the last packet", [](SampleJob& job) { job.packet = 2; }},
                                   {false, "a packet that the stream lacks", [](SampleJob& job) { job.packet = 3; }},
                                   {false, "no pose", [](SampleJob& job) { job.pose = nullptr; }},
                                   {false, "pose off the alignment", [](SampleJob& job) { job.pose += 4; }}});
}

TEST_P(Sample, AgreesWithTheRowsToTheirQuantisationOnEveryTarget) {
  for (const Kernels& kernels : runnable_kernels()) {
    for (int step = 0; step <= 8 * 7; ++step) {
      const double row = step / 7.0;
      const Ticks time = rows_.first_row + Ticks{std::llround(row * static_cast<double>(rows_.step.count()))};
      const int from = std::min(step / 7, rows_.row_count - 1);
      for (int packet = 0; packet < packets_for(rows_.bone_count); ++packet) {
        const Packet out = sample(kernels, block_.stream(), time, packet);
        for (int lane = 0; lane < packet_bones; ++lane) {
          // A flip of the stored sign is the same rotation.
          double sign = 1.0;
          double dot = 0.0;
          for (int c = 0; c < 4; ++c) {
            dot += static_cast<double>(out.lanes[c][lane]) * expected_lane(rows_, from, row - from, packet, c, lane);
          }
          if (dot < 0.0) sign = -1.0;
          for (int c = 0; c < rows_.components; ++c) {
            ASSERT_NEAR((c < 4 ? sign : 1.0) * static_cast<double>(out.lanes[c][lane]),
                        expected_lane(rows_, from, row - from, packet, c, lane), 6e-5)
                << kernels.target << " step " << step << " component " << c << " lane " << lane;
          }
        }
      }
    }
  }
}

TEST_P(Sample, ShowsARowItselfAtItsTime) {
  const SampledPacket& header = block_.stream().packets()[0];
  for (const Kernels& kernels : runnable_kernels()) {
    for (int row = 0; row < rows_.row_count; ++row) {
      const Packet out = sample(kernels, block_.stream(), rows_.first_row + row * rows_.step, 0);
      for (int axis = 0; axis < 3; ++axis) {
        for (int bone = 0; bone < packet_bones; ++bone) {
          const int quad = bone / quad_bones;
          const int lane = lane_in_quad(axis, bone);
          std::int16_t word = 0;
          std::memcpy(&word, block_.stream().row(row) + header.position_offset[quad] + lane * 2, 2);
          const auto& range = header.at<QuadRange>(header.position_range[quad]);
          const float step = range.step[lane] / row_weight_unit;
          const float expected = range.base[lane] + step * word;
          ASSERT_NEAR(out.lanes[4 + axis][bone], expected, 1e-6F) << kernels.target << " " << row << " " << bone;
        }
      }
    }
  }
}

TEST_P(Sample, LeavesRotationsUnitToAMillionth) {
  for (const Kernels& kernels : runnable_kernels()) {
    for (int step = 0; step <= 64; ++step) {
      const Packet out = sample(kernels, block_.stream(), rows_.first_row + step * rows_.step / 8, step % 3);
      for (int lane = 0; lane < packet_bones; ++lane) {
        const glm::dquat q(out.lanes[3][lane], out.lanes[0][lane], out.lanes[1][lane], out.lanes[2][lane]);
        ASSERT_NEAR(glm::length(q), 1.0, 1e-6) << kernels.target << " " << step << " " << lane;
      }
    }
  }
}

TEST_P(Sample, HoldsTheIdentityBehindTheLastBone) {
  const int last = packets_for(rows_.bone_count) - 1;
  for (const Kernels& kernels : runnable_kernels()) {
    const Packet out = sample(kernels, block_.stream(), rows_.first_row + rows_.step / 3, last);
    for (int lane = rows_.bone_count - last * packet_bones; lane < packet_bones; ++lane) {
      for (int component = 0; component < rows_.components; ++component) {
        EXPECT_NEAR(out.lanes[component][lane], component == 3 || component >= 7 ? 1.0F : 0.0F, 1e-6F)
            << kernels.target << " " << lane;
      }
    }
  }
}

TEST_P(Sample, IsTheSameToTheBitAmongTargetsThatFuse) {
  for (const Kernels& kernels : runnable_kernels()) {
    if (kernels.fused_multiply_add != best_kernels().fused_multiply_add) continue;
    for (int step = 0; step <= 64; ++step) {
      const Ticks time = rows_.first_row + step * rows_.step / 8;
      const Packet out = sample(kernels, block_.stream(), time, step % 3);
      const Packet best = sample(best_kernels(), block_.stream(), time, step % 3);
      ASSERT_EQ(bits(out), bits(best)) << kernels.target << " " << step;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(States, Sample, ::testing::Values(rigid_components, general_components),
                         [](const auto& components) { return components.param == 7 ? "rigid" : "general"; });

TEST(SampleOfRowsAsFarApartAsTheyMayBe, LeavesRotationsUnitToAMillionth) {
  SampledRows rows = still_rows(16, rigid_components, 2);
  for (int lane = 0; lane < packet_bones; ++lane) {
    for (int axis = 0; axis < 4; ++axis) {
      row_value(rows, 0, 0, axis, lane) = axis == 3 ? 1.0F : 0.0F;
      row_value(rows, 1, 0, axis, lane) = axis == 3 ? 0.801F : 0.0F;
    }
    row_value(rows, 1, 0, lane % 3, lane) = std::sqrt(1.0F - 0.801F * 0.801F);
  }
  ASSERT_FALSE(turns_too_far(rows));
  const StreamBlock block(rows);
  for (const Kernels& kernels : runnable_kernels()) {
    for (int step = 0; step <= 64; ++step) {
      const Packet out = sample(kernels, block.stream(), rows.first_row + step * rows.step / 64, 0);
      for (int lane = 0; lane < packet_bones; ++lane) {
        const glm::dquat q(out.lanes[3][lane], out.lanes[0][lane], out.lanes[1][lane], out.lanes[2][lane]);
        ASSERT_NEAR(glm::length(q), 1.0, 1e-6) << kernels.target << " " << step << " " << lane;
      }
    }
  }
}

TEST(SampleOfARigidClip, DoesNotTouchWhatTheStateHasNot) {
  const StreamBlock block(wavy_rows(16, rigid_components, 3));
  for (const Kernels& kernels : runnable_kernels()) {
    const Packet out = sample(kernels, block.stream(), Ticks{}, 0);
    for (int component = rigid_components; component < general_components; ++component) {
      for (const float value : out.lanes[component]) EXPECT_EQ(value, 0.0F) << kernels.target;
    }
  }
}

TEST(SampleOfAConstantClip, IsExactlyTheStoredPose) {
  const SampledRows rows = still_rows(16, general_components, 4);
  const StreamBlock block(rows);
  for (const Kernels& kernels : runnable_kernels()) {
    const Packet out = sample(kernels, block.stream(), rows.step, 0);
    for (int component = 0; component < general_components; ++component) {
      for (int lane = 0; lane < packet_bones; ++lane) {
        EXPECT_NEAR(out.lanes[component][lane], row_value(rows, 0, 0, component, lane), 1e-7F) << kernels.target;
      }
    }
  }
}

}  // namespace
}  // namespace throng::anim::sample_test
