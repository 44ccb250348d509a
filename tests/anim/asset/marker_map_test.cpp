#include "engine/anim/asset/marker_map.h"

#include <vector>

#include <gtest/gtest.h>

namespace throng::anim::marker_map_test {
namespace {

constexpr std::uint32_t left = 0, right = 1, clap = 2;
constexpr FineTicks fine = fine_ticks_per_tick.count();

struct Clip {
  std::vector<DataKey> keys;
  Ticks duration{1000};
  MarkedClip marked() const { return {.keys = keys, .duration = duration}; }
};

const Clip walk{.keys = {{Ticks{100}, left}, {Ticks{600}, right}}};
const Clip run{.keys = {{Ticks{50}, right}, {Ticks{250}, left}}, .duration = Ticks{500}};

FineTicks position(const MarkerMap& map, FineTicks leader) { return map.way(leader).position(leader); }

TEST(MarkerMap, LeadsFromMarkerToMarker) {
  const MarkerMap map(walk.marked(), run.marked());
  ASSERT_TRUE(map.has_markers());
  EXPECT_EQ(position(map, 100 * fine), 250 * fine) << "left";
  EXPECT_EQ(position(map, 600 * fine), 50 * fine) << "right";
  EXPECT_EQ(position(map, 350 * fine), 400 * fine) << "half the way from left to right, which is 300 over the seam";
  EXPECT_EQ(position(map, 850 * fine), 150 * fine) << "half the way from right to left, which is 200";
  EXPECT_EQ(position(map, 50 * fine), 230 * fine) << "nine tenths of that way";
}

TEST(MarkerMap, SaysHowLongItStaysLinear) {
  const MarkerMap map(walk.marked(), run.marked());
  const MarkerMap::Way way = map.way(50 * fine);
  EXPECT_EQ(way.begin, -400 * fine);
  EXPECT_EQ(way.end, 100 * fine);
  EXPECT_DOUBLE_EQ(way.rate, 0.4);
}

TEST(MarkerMap, NeverComesToAMarkerBeforeTheLeaderDoes) {
  const Clip odd{.keys = {{Ticks{33}, left}, {Ticks{701}, right}}, .duration = Ticks{997}};
  const MarkerMap map(walk.marked(), odd.marked());
  for (const FineTicks marker : {100, 600}) {
    const FineTicks before = position(map, marker * fine - 1), there = position(map, marker * fine);
    EXPECT_LT(before, there);
    EXPECT_EQ(there, (marker == 100 ? 33 : 701) * fine);
  }
}

TEST(MarkerMap, LeavesKeysOutThatOnlyOneClipHas) {
  Clip clapping = run;
  clapping.keys.insert(clapping.keys.begin() + 1, DataKey{Ticks{100}, clap});
  const MarkerMap map(walk.marked(), clapping.marked());
  ASSERT_TRUE(map.has_markers());
  EXPECT_EQ(position(map, 600 * fine), 50 * fine);
}

TEST(MarkerMap, OfOneMarkerShiftsTheWholeLoop) {
  const Clip once{.keys = {{Ticks{100}, left}}}, other{.keys = {{Ticks{300}, left}}, .duration = Ticks{2000}};
  const MarkerMap map(once.marked(), other.marked());
  ASSERT_TRUE(map.has_markers());
  EXPECT_EQ(position(map, 100 * fine), 300 * fine);
  EXPECT_EQ(position(map, 600 * fine), 1300 * fine);
}

TEST(MarkerMap, ShiftsAsLittleAsItCanWhereSeveralStepsFit) {
  const Clip four{.keys = {{Ticks{0}, left}, {Ticks{250}, right}, {Ticks{500}, left}, {Ticks{750}, right}}};
  const Clip late{.keys = {{Ticks{20}, left}, {Ticks{270}, right}, {Ticks{520}, left}, {Ticks{770}, right}}};
  EXPECT_EQ(position(MarkerMap(four.marked(), late.marked()), 500 * fine), 520 * fine);
}

TEST(MarkerMap, GoesByThePhaseWhereMarkersAreUnlikeOrNone) {
  const Clip none{.keys = {}, .duration = Ticks{300}};
  const Clip gallop{.keys = {{Ticks{0}, left}, {Ticks{10}, left}, {Ticks{500}, right}}};
  const Clip at_once{.keys = {{Ticks{100}, left}, {Ticks{100}, right}}};
  const Clip at_the_seam{.keys = {{Ticks{0}, left}, {Ticks{1000}, right}}};
  for (const Clip* other : {&none, &gallop, &at_once, &at_the_seam}) {
    const MarkerMap map(walk.marked(), other->marked());
    EXPECT_FALSE(map.has_markers());
    EXPECT_EQ(position(map, 500 * fine), other->duration.count() * fine / 2);
  }
}

TEST(MarkerMap, GoesByThePhaseWhereThereAreTooManyMarkers) {
  Clip busy;
  for (int i = 0; i < 17; ++i) busy.keys.push_back({Ticks{i * 10}, left});
  EXPECT_FALSE(MarkerMap(busy.marked(), busy.marked()).has_markers());
}

}  // namespace
}  // namespace throng::anim::marker_map_test
