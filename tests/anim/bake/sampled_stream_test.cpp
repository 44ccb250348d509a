#include "engine/anim/asset/sampled_stream.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "tests/anim/bake/sampled_rows.h"

namespace throng::anim::sampled_stream_test {
namespace {

using namespace sampled_rows;

std::int16_t stored(const std::byte* row, std::int32_t offset, int lane) {
  std::int16_t value = 0;
  std::memcpy(&value, row + offset + lane * 2, sizeof(value));
  return value;
}

std::int16_t stored_rotation(const std::byte* row, const SampledPacket& packet, int axis, int bone) {
  return stored(row, packet.rotation_offset, rotation_lane(packet.lanes, axis, bone));
}

TEST(SampledStream, GivesEveryBoneAndComponentAPlaceOfItsOwn) {
  std::set<int> quad;
  for (const int lanes : {4, 8, 12, 16}) {
    std::set<int> rotations;
    for (int bone = 0; bone < lanes; ++bone) {
      for (int component = 0; component < 4; ++component) rotations.insert(rotation_lane(lanes, component, bone));
    }
    EXPECT_EQ(static_cast<int>(rotations.size()), 4 * lanes);
    EXPECT_LT(*rotations.rbegin(), 4 * lanes);
  }
  for (int bone = 2 * quad_bones; bone < 3 * quad_bones; ++bone) {
    for (int component = 0; component < 3; ++component) quad.insert(lane_in_quad(component, bone));
  }
  EXPECT_EQ(static_cast<int>(quad.size()), 3 * quad_bones);
  EXPECT_EQ(*quad.rbegin(), 3 * quad_bones - 1);
}

TEST(SampledStream, IsOneBlockWithRoomForAVectorBehindItsRows) {
  for (const int bones : {1, 16, 17, 62}) {
    const StreamBlock block(wavy_rows(bones, general_components, 5));
    EXPECT_EQ(block.stream().total_size, block.stream().rows_offset + 5 * block.stream().row_stride + 64);
    EXPECT_EQ(block.stream().rows_offset % 64, 0U);
    EXPECT_EQ(block.stream().row_stride % 64, 0U);
  }
}

TEST(SampledStream, KeepsPositionsAndScalesToASixtyFiveThousandthOfTheirRange) {
  const SampledRows rows = wavy_rows(37, general_components, 40);
  const StreamBlock block(rows);
  const SampledStream& stream = block.stream();
  for (int packet = 0; packet < stream.packet_count(); ++packet) {
    const SampledPacket& header = stream.packets()[packet];
    for (int bone = 0; bone < packet_bones; ++bone) {
      for (int component = 4; component < general_components; ++component) {
        const int quad = bone / quad_bones;
        const int lane = lane_in_quad((component - 4) % 3, bone);
        const bool position = component < 7;
        const auto& of_quad = header.at<QuadRange>(position ? header.position_range[quad] : header.scale_range[quad]);
        const std::int32_t offset = position ? header.position_offset[quad] : header.scale_offset[quad];
        const float base = of_quad.base[lane];
        const float step = offset < 0 ? 0.0F : of_quad.step[lane] / row_weight_unit;
        const float range = step * 65534.0F;
        for (int row = 0; row < rows.row_count; ++row) {
          const std::int16_t value = offset < 0 ? std::int16_t{0} : stored(stream.row(row), offset, lane);
          EXPECT_NEAR(base + step * static_cast<float>(value), row_value(rows, row, packet, component, bone),
                      range / 65534.0F + 1e-7F);
        }
      }
    }
  }
}

TEST(SampledStream, PutsNeighbouringRotationsOnOneHemisphere) {
  const StreamBlock block(wavy_rows(37, rigid_components, 40));
  const SampledStream& stream = block.stream();
  for (int packet = 0; packet < stream.packet_count(); ++packet) {
    const SampledPacket& of = stream.packets()[packet];
    ASSERT_GE(of.rotation_offset, 0);
    for (int row = 1; row < stream.row_count; ++row) {
      for (int bone = 0; bone < of.lanes; ++bone) {
        int dot = 0;
        for (int axis = 0; axis < 4; ++axis) {
          dot += stored_rotation(stream.row(row - 1), of, axis, bone) / 2 *
                 stored_rotation(stream.row(row), of, axis, bone) / 2;
        }
        EXPECT_GE(dot, 0) << row << " " << bone;
      }
    }
  }
}

TEST(SampledStream, StoresNothingInTheRowsForWhatDoesNotMove) {
  const StreamBlock block(still_rows(40, general_components, 30));
  EXPECT_EQ(block.stream().row_stride, 0U);
  for (int packet = 0; packet < 3; ++packet) {
    EXPECT_EQ(block.stream().packets()[packet].rotation_offset, -1);
    for (const std::int32_t offset : block.stream().packets()[packet].position_offset) EXPECT_EQ(offset, -1);
    for (const std::int32_t offset : block.stream().packets()[packet].scale_offset) EXPECT_EQ(offset, -1);
  }
}

TEST(SampledStream, StoresRotationsThatMoveByPackets) {
  SampledRows rows = still_rows(40, rigid_components, 30);
  row_value(rows, 11, 1, 1, 3) += 0.01F;  // one rotation of the second packet
  const StreamBlock block(rows);
  const SampledPacket* packets = block.stream().packets();
  EXPECT_EQ(packets[0].rotation_offset, -1);
  EXPECT_EQ(packets[1].rotation_offset, 0);
  EXPECT_EQ(packets[2].rotation_offset, -1);
  EXPECT_EQ(block.stream().row_stride, 128U);
}

TEST(SampledStream, StoresNoRotationsOfQuadsWithoutABone) {
  for (const auto& [bones, stride] : {std::pair{16, 128U}, {3, 64U}, {24, 192U}, {41, 384U}, {36, 320U}}) {
    SampledRows rows = still_rows(bones, rigid_components, 30);
    for (int packet = 0; packet < packets_for(bones); ++packet) row_value(rows, 11, packet, 1, 0) += 0.01F;
    EXPECT_EQ(StreamBlock(rows).stream().row_stride, stride) << bones;
  }
}

TEST(SampledStream, KeepsEqualConstantsOnce) {
  const auto bytes = [](int packets) {
    SampledRows rows = still_rows(packets * packet_bones, rigid_components, 1);
    const std::size_t packet = rows.rows.size() / static_cast<std::size_t>(packets);
    for (int i = 1; i < packets; ++i) {
      std::copy_n(rows.rows.begin(), packet, rows.rows.begin() + static_cast<std::ptrdiff_t>(packet) * i);
    }
    return StreamBlock(rows).stream().total_size;
  };
  EXPECT_LE(bytes(9) - bytes(1), 8 * sizeof(SampledPacket) + 64);
}

TEST(SampledStream, StoresPositionsThatMoveByQuads) {
  SampledRows rows = still_rows(40, rigid_components, 30);
  row_value(rows, 11, 1, 5, 3) += 0.01F;   // one position of the second packet, in its first quad
  row_value(rows, 12, 1, 6, 15) += 0.01F;  // and one in its last
  const StreamBlock block(rows);
  const SampledPacket* packets = block.stream().packets();
  for (const std::int32_t offset : packets[0].position_offset) EXPECT_EQ(offset, -1);
  for (const std::int32_t offset : packets[2].position_offset) EXPECT_EQ(offset, -1);
  EXPECT_EQ(packets[1].rotation_offset, -1);
  EXPECT_EQ(packets[1].position_offset[0], 0);
  EXPECT_EQ(packets[1].position_offset[1], -1);
  EXPECT_EQ(packets[1].position_offset[2], -1);
  EXPECT_EQ(packets[1].position_offset[3], 24);
  EXPECT_EQ(block.stream().row_stride, 64U);
}

TEST(SampledStream, KnowsTheQuadsThatAreDisplacedAndPacketsFromTheSixteenthOnTogether) {
  SampledRows rows = still_rows(20 * packet_bones, rigid_components, 3);
  for (int packet = 0; packet < 20; ++packet) {
    for (int row = 0; row < rows.row_count; ++row) {
      for (int component = 4; component < rigid_components; ++component) {
        for (int lane = 0; lane < packet_bones; ++lane) row_value(rows, row, packet, component, lane) = 0.0F;
      }
    }
  }
  ASSERT_EQ(StreamBlock(rows).stream().displaced_quads, 0U);
  row_value(rows, 1, 0, 4, 1) = 0.5F;                                        // moves
  for (int row = 0; row < 3; ++row) row_value(rows, row, 3, 6, 12) = 0.25F;  // stands still elsewhere
  row_value(rows, 2, 16, 5, 4) = row_value(rows, 2, 19, 5, 8) = 0.125F;      // in packets that share bits
  const std::uint64_t quads = StreamBlock(rows).stream().displaced_quads;
  EXPECT_EQ(quads_of_packet(quads, 0), 0b0001U);
  EXPECT_EQ(quads_of_packet(quads, 1), 0b0000U);
  EXPECT_EQ(quads_of_packet(quads, 3), 0b1000U);
  for (const int packet : {15, 16, 19}) EXPECT_EQ(quads_of_packet(quads, packet), 0b0110U);
}

TEST(SampledStream, TakesAllQuadsOfGeneralSkeletonsForDisplaced) {
  const StreamBlock block(still_rows(40, general_components, 3));
  for (const int packet : {0, 1, 2}) EXPECT_EQ(quads_of_packet(block.stream().displaced_quads, packet), all_quads);
}

TEST(SampledStream, TakesNoiseBelowTheQuantisationForConstant) {
  SampledRows rows = still_rows(16, rigid_components, 30);
  for (int row = 0; row < 30; row += 2) row_value(rows, row, 0, 0, 5) += 0.9F / 32767.0F;
  EXPECT_EQ(StreamBlock(rows).stream().packets()[0].rotation_offset, -1);
  row_value(rows, 7, 0, 0, 5) += 2.0F / 32767.0F;
  EXPECT_GE(StreamBlock(rows).stream().packets()[0].rotation_offset, 0);
}

TEST(SampledStream, ClampsInsteadOfWrapping) {
  SampledRows rows = still_rows(16, rigid_components, 2);
  row_value(rows, 0, 0, 3, 0) = 1.00002F;  // a sloppy unit quaternion
  row_value(rows, 1, 0, 3, 0) = 0.9F;
  const StreamBlock block(rows);
  EXPECT_EQ(stored_rotation(block.stream().row(0), block.stream().packets()[0], 3, 0), 32767);
}

class Locate : public ::testing::Test {
 protected:
  const SampledRows rows_ = wavy_rows(16, rigid_components, 4);  // rows at -1/2, 1/2, 3/2, 5/2 steps
  const StreamBlock block_ = StreamBlock(rows_);
  const SampledStream& stream_ = block_.stream();
  const Ticks step_ = rows_.step;

  void expect(Ticks time, int from, int to, std::int32_t fraction) const {
    const SamplePoint point = locate(stream_, time);
    EXPECT_EQ(point.from, stream_.row(from)) << time;
    EXPECT_EQ(point.to, stream_.row(to)) << time;
    EXPECT_EQ(point.weights, row_weights(fraction)) << time;
  }
};

TEST_F(Locate, FindsTheTwoRowsAroundATime) {
  expect(-step_ / 2, 0, 1, 0);
  expect(Ticks{}, 0, 1, sample_fraction_one / 2);
  expect(step_ / 2, 1, 2, 0);
  expect(step_, 1, 2, sample_fraction_one / 2);
  expect(step_ + step_ / 4, 1, 2, sample_fraction_one * 3 / 4);
}

TEST_F(Locate, ShowsTheNearestRowOutsideTheRows) {
  expect(-step_ / 2 - Ticks{1}, 0, 0, 0);
  expect(-10 * step_, 0, 0, 0);
  expect(std::numeric_limits<Ticks>::min(), 0, 0, 0);
  expect(5 * step_ / 2, 3, 3, 0);
  expect(100 * step_, 3, 3, 0);
  expect(std::numeric_limits<Ticks>::max(), 3, 3, 0);
}

TEST(RowWeights, AreNegativeAndFitSixteenBitsFromOneRowToTheNext) {
  for (const std::int32_t fraction : {0, 1, 12345, sample_fraction_one - 1, sample_fraction_one}) {
    EXPECT_EQ(static_cast<std::int16_t>(row_weights(fraction)), fraction - sample_fraction_one);
    EXPECT_EQ(static_cast<std::int16_t>(row_weights(fraction) >> 16U), -fraction);
  }
}

TEST_F(Locate, ReachesTheNextRowInTheLastTick) {
  expect(step_ / 2 - Ticks{1}, 0, 1, sample_fraction_one);
  expect(5 * step_ / 2 - Ticks{1}, 2, 3, sample_fraction_one);
}

/// Rows at steps 0, 1, 4, 36 and 38.
TEST(LocateAmongUnevenRows, FindsTheTwoRowsAroundATimeAndTheWayBetweenThem) {
  SampledRows rows = wavy_rows(16, rigid_components, 5);
  rows.first_row = Ticks{};
  rows.gaps = {1, 3, 32, 2};
  const StreamBlock block(rows);
  const SampledStream& stream = block.stream();
  ASSERT_EQ(stream.step_count, 38);
  const int starts[] = {0, 1, 4, 36, 38};
  for (int eighths = 0; eighths < 38 * 8; ++eighths) {
    int row = 0;
    while (starts[row + 1] * 8 <= eighths) ++row;
    const double fraction = (eighths / 8.0 - starts[row]) / (starts[row + 1] - starts[row]);
    const SamplePoint point = locate(stream, rows.step * eighths / 8);
    EXPECT_EQ(point.from, stream.row(row)) << eighths;
    EXPECT_EQ(point.to, stream.row(row + 1)) << eighths;
    EXPECT_NEAR(-static_cast<std::int16_t>(point.weights >> 16U), fraction * sample_fraction_one, 0.51) << eighths;
  }
  EXPECT_EQ(locate(stream, 38 * rows.step).from, stream.row(4));
}

TEST(LocateAmongUnevenRows, ReachesTheNextRowInTheLastTickWhateverTheGap) {
  for (int gap = 1; gap <= most_steps_between_rows; ++gap) {
    SampledRows rows = wavy_rows(16, rigid_components, 2);
    rows.first_row = Ticks{};
    rows.gaps = {static_cast<std::uint8_t>(gap)};
    const StreamBlock block(rows);
    const SamplePoint point = locate(block.stream(), gap * rows.step - Ticks{1});
    EXPECT_EQ(point.to, block.stream().row(1)) << gap;
    EXPECT_EQ(point.weights, row_weights(sample_fraction_one)) << gap;
  }
}

TEST(LocateInALateClip, HoldsTheFirstRowUntilItsTime) {
  SampledRows rows = wavy_rows(16, rigid_components, 2);
  rows.first_row = 3 * rows.step;
  const StreamBlock block(rows);
  EXPECT_EQ(locate(block.stream(), Ticks{}).to, block.stream().row(0));
  EXPECT_EQ(locate(block.stream(), 3 * rows.step + rows.step / 4).weights, row_weights(sample_fraction_one / 4));
}

TEST(LocateInAClipOfOneRow, AlwaysShowsIt) {
  const StreamBlock block(wavy_rows(16, rigid_components, 1));
  for (const Ticks time : {Ticks{-1}, Ticks{0}, ticks_per_second}) {
    EXPECT_EQ(locate(block.stream(), time).from, block.stream().row(0));
    EXPECT_EQ(locate(block.stream(), time).to, block.stream().row(0));
  }
}

TEST(SampledRows, TurnTooFarWhereTwoLieMoreThan74DegreesApartWhicheverTheirSigns) {
  const auto turned = [](double degrees, float sign) {
    SampledRows rows = still_rows(20, rigid_components, 3);
    const double half = degrees * std::numbers::pi / 360.0;
    for (int axis = 0; axis < 4; ++axis) {
      for (int row = 0; row < 3; ++row) row_value(rows, row, 1, axis, 2) = axis == 3 ? 1.0F : 0.0F;
    }
    row_value(rows, 2, 1, 1, 2) = sign * static_cast<float>(std::sin(half));
    row_value(rows, 2, 1, 3, 2) = sign * static_cast<float>(std::cos(half));
    return rows;
  };
  for (const float sign : {1.0F, -1.0F}) {
    EXPECT_FALSE(turns_too_far(turned(73.0, sign)));
    EXPECT_TRUE(turns_too_far(turned(75.0, sign)));
  }
}

}  // namespace
}  // namespace throng::anim::sampled_stream_test
