#include "app/show/report/tuning_sweep.h"

#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace throng::app::tuning_sweep_test {
namespace {

constexpr int frames_a_visit = TuningSweep::settling_frames + TuningSweep::measured_frames;

/// Poses frames until the sweep ends, `cost_of` what each takes; the tiles that were asked for, frame by frame.
template <typename CostOf>
std::vector<int> run(TuningSweep& sweep, CostOf&& cost_of) {
  std::vector<int> tiles;
  while (sweep.runs()) {
    tiles.push_back(sweep.tuning().system.tile);
    sweep.add(cost_of(tiles.back(), tiles.size()));
  }
  return tiles;
}

UpdateCost dearer_when_narrow(int tile, std::size_t) {
  return {.milliseconds = tile == 8 ? 1.0 : 2.0 + 1.0 / tile, .tasks = 64U / static_cast<unsigned>(tile), .bytes = 100};
}

TEST(TuningSweep, VisitsEveryStopInEveryRoundSoThatTheyTakeTurns) {
  TuningSweep sweep;
  sweep.start(SweptValue::tile, {}, 4);
  const std::vector<int> tiles = run(sweep, dearer_when_narrow);
  const std::vector<int> stops{1, 2, 4, 8, 16};
  ASSERT_EQ(tiles.size(), stops.size() * TuningSweep::rounds * frames_a_visit);
  for (std::size_t frame = 0; frame < tiles.size(); ++frame) {
    EXPECT_EQ(tiles[frame], stops[frame / frames_a_visit % stops.size()]);
  }
  EXPECT_TRUE(sweep.curve().complete());
}

TEST(TuningSweep, ChangesTheValueThatItGoesThroughAndNoOther) {
  const Tuning start{.agents = 70, .system = {.pus = 3, .local_store_bytes = 128 * bytes_a_kib, .tile = 4}};
  for (const SweptValue value : {SweptValue::pus, SweptValue::local_store, SweptValue::tile, SweptValue::grain}) {
    TuningSweep sweep;
    sweep.start(value, start, 8);
    std::set<double> seen;
    while (sweep.runs()) {
      Tuning tuning = sweep.tuning();
      seen.insert(swept_value(value, tuning));
      set_swept_value(value, swept_value(value, start), tuning);
      EXPECT_EQ(tuning, start);
      sweep.add({.milliseconds = 1});
    }
    EXPECT_EQ(seen.size(), sweep.curve().stops.size());
  }
}

TEST(TuningSweep, TellsTheMedianOfEachStopAndWhichIsLowest) {
  TuningSweep sweep;
  sweep.start(SweptValue::tile, {}, 4);
  // Every third frame stalls, and the first frames at a stop are slow.
  run(sweep, [](int tile, std::size_t frame) {
    UpdateCost cost = dearer_when_narrow(tile, frame);
    const bool settles = (frame - 1) % frames_a_visit < TuningSweep::settling_frames;
    if (settles || frame % 3 == 0) cost.milliseconds += 100;
    return cost;
  });
  for (const SweepStop& stop : sweep.curve().stops) {
    const UpdateCost expected = dearer_when_narrow(static_cast<int>(stop.value), 0);
    EXPECT_TRUE(stop.known);
    EXPECT_EQ(stop.cost.milliseconds, expected.milliseconds);
    EXPECT_EQ(stop.cost.tasks, expected.tasks);
    EXPECT_EQ(stop.cost.bytes, expected.bytes);
  }
  ASSERT_NE(sweep.curve().lowest(), nullptr);
  EXPECT_EQ(sweep.curve().lowest()->value, 8);
}

TEST(TuningSweep, GoesOnWithoutAStopThatIsRefused) {
  TuningSweep sweep;
  sweep.start(SweptValue::local_store, {}, 4);
  EXPECT_EQ(local_store_kib(sweep.tuning()), 16);
  sweep.refuse("too small");
  sweep.refuse("too small as well");
  int frames = 0;
  for (; sweep.runs(); ++frames) {
    EXPECT_GE(local_store_kib(sweep.tuning()), 64) << "refused once, it is not asked for again";
    sweep.add({.milliseconds = 1});
  }
  const SweepCurve& curve = sweep.curve();
  EXPECT_EQ(frames, TuningSweep::rounds * frames_a_visit * static_cast<int>(curve.stops.size() - 2));
  EXPECT_TRUE(curve.stops[0].refused);
  EXPECT_FALSE(curve.stops[0].known);
  EXPECT_EQ(curve.refusal, "too small");
  EXPECT_TRUE(curve.complete());
}

TEST(TuningSweep, EndsWhereEveryStopIsRefused) {
  TuningSweep sweep;
  sweep.start(SweptValue::tile, {}, 4);
  for (int stop = 0; stop < 5; ++stop) {
    ASSERT_TRUE(sweep.runs());
    sweep.refuse("no");
  }
  EXPECT_FALSE(sweep.runs());
  EXPECT_EQ(sweep.curve().lowest(), nullptr);
}

TEST(TuningSweep, StoppedKeepsWhatItKnowsAndBeginsAnewFromWhatIsThen) {
  TuningSweep sweep;
  sweep.start(SweptValue::tile, {}, 4);
  for (int frame = 0; frame < frames_a_visit; ++frame) sweep.add({.milliseconds = 3});
  sweep.stop();
  EXPECT_FALSE(sweep.runs());
  EXPECT_FALSE(sweep.curve().complete());
  EXPECT_TRUE(sweep.curve().stops[0].known);
  EXPECT_FALSE(sweep.curve().stops[1].known);
  Tuning other;
  other.system.pus = 2;
  EXPECT_FALSE(sweep.began_with(other));
  sweep.start(SweptValue::tile, other, 4);
  EXPECT_TRUE(sweep.began_with(other));
  EXPECT_EQ(sweep.tuning().system.pus, 2);
  EXPECT_FALSE(sweep.curve().stops[0].known);
}

TEST(TuningSweep, TriesAsManyPusAsTheMachineHas) {
  TuningSweep sweep;
  const auto most = [&](int threads) {
    sweep.start(SweptValue::pus, {}, threads);
    return sweep.curve().stops.back().value;
  };
  EXPECT_EQ(most(24), 24);
  EXPECT_EQ(most(1), 4) << "more than that machine has, to see that it does not pay";
}

}  // namespace
}  // namespace throng::app::tuning_sweep_test
