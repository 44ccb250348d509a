#include "engine/anim/asset/root_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/asset/data_keys.h"

namespace throng::anim::root_curve_test {
namespace {

constexpr Ticks second = ticks_per_second;
constexpr double pi = std::numbers::pi;

FineTicks fine(double seconds) { return to_ticks(seconds) * fine_ticks_per_tick; }

struct NamedCurve {
  std::string name;
  RootCurve curve;
};
std::ostream& operator<<(std::ostream& out, const NamedCurve& named) { return out << named.name; }

RootCurve bent(double yaw) {
  const Ticks duration = second * 6 / 5 + Ticks{7};
  return {.duration = duration,
          .keys = {{},
                   {.time = duration / 5, .x = 0.3, .z = 0.2, .yaw = 0.5},
                   {.time = duration / 2, .x = 0.1, .z = 0.9, .yaw = -0.2},
                   {.time = duration * 2 / 3, .x = 0.2, .y = 0.1, .z = 1.1, .yaw = yaw / 3.0},
                   {.time = duration * 5 / 6, .x = 0.3, .y = 0.2, .z = 1.3, .yaw = yaw / 1.5},
                   {.time = duration, .x = 0.4, .y = 0.3, .z = 1.6, .yaw = yaw}}};
}

double distance(const RootMotion& a, const RootMotion& b) {
  return glm::distance(a.translation, b.translation) + std::abs(a.yaw - b.yaw);
}

/// How far a motion of that length, in fine ticks, may lead, which is what errors are relative to.
double reach(const RootCurve& curve, double length) {
  const double loops = length / static_cast<double>(curve.duration * fine_ticks_per_tick);
  return 10.0 * (1.0 + loops);
}

class Displacement : public testing::TestWithParam<NamedCurve> {
 protected:
  const RootCurve& curve() const { return GetParam().curve; }
  FineTicks length() const { return curve().duration * fine_ticks_per_tick; }
};

/// Where `loops` loops lead: the sum of the loop's step, turned by the loops before it.
glm::dvec3 sum_of_loops(const RootMotion& loop, int loops) {
  long double x = 0.0L;
  long double z = 0.0L;
  for (int i = 0; i < loops; ++i) {
    const long double yaw = static_cast<long double>(loop.yaw) * i;
    x += static_cast<long double>(loop.translation.x) * std::cos(yaw) +
         static_cast<long double>(loop.translation.z) * std::sin(yaw);
    z += static_cast<long double>(loop.translation.z) * std::cos(yaw) -
         static_cast<long double>(loop.translation.x) * std::sin(yaw);
  }
  return {static_cast<double>(x), loop.translation.y * loops, static_cast<double>(z)};
}

TEST_P(Displacement, OfWholeLoopsIsTheSumOfItsLoops) {
  const RootMotion loop = displacement(curve(), 0, length(), true);
  for (const int loops : {1, 2, 3, 10, 101, 20'000}) {
    const RootMotion ahead = displacement(curve(), 0, loops * length(), true);
    EXPECT_LT(glm::distance(ahead.translation, sum_of_loops(loop, loops)), 1e-9 * loops) << loops;
    EXPECT_NEAR(ahead.yaw, loops * loop.yaw, 1e-12 * loops);
    const RootMotion back = displacement(curve(), loops * length(), 0, true);
    EXPECT_LT(distance(back, inverse(ahead)), 1e-9 * loops) << loops;
  }
}

TEST_P(Displacement, OfALoopIsTheCurvesLastKey) {
  const RootKey& last = curve().keys.back();
  const RootMotion loop = displacement(curve(), 0, length(), true);
  EXPECT_LT(distance(loop, {.translation = {last.x, last.y, last.z}, .yaw = last.yaw}), 1e-12);
}

TEST_P(Displacement, IsTheClosedFormAfterTenThousandRandomSteps) {
  std::mt19937_64 random(5);
  const auto any = [&](FineTicks limit) {
    return static_cast<FineTicks>(random() % static_cast<std::uint64_t>(limit));
  };
  const FineTicks start = length() / 3;
  FineTicks position = start;
  double walked = 0.0;  // fine ticks; more than 64 bits hold
  RootMotion total;
  for (int i = 0; i < 10'000; ++i) {
    const FineTicks sizes[] = {0, any(3), any(length() / 50), any(length()), any(length() * 300)};
    const FineTicks step = (random() % 2 == 0 ? 1 : -1) * sizes[random() % 5];
    total = compose(total, displacement(curve(), position, position + step, true));
    position += step;
    walked += static_cast<double>(std::abs(step));
    ASSERT_LT(distance(total, displacement(curve(), start, position, true)), 1e-9 * reach(curve(), walked)) << i;
  }
}

TEST_P(Displacement, OfPiecesComposesToThatOfTheWhole) {
  std::mt19937_64 random(9);
  for (int i = 0; i < 200; ++i) {
    std::vector<FineTicks> cuts(7);
    for (FineTicks& cut : cuts)
      cut = static_cast<FineTicks>(random() % static_cast<std::uint64_t>(9 * length())) - 4 * length();
    RootMotion pieces;
    for (std::size_t k = 1; k < cuts.size(); ++k) {
      pieces = compose(pieces, displacement(curve(), cuts[k - 1], cuts[k], true));
    }
    ASSERT_LT(distance(pieces, displacement(curve(), cuts.front(), cuts.back(), true)), 1e-9);
  }
}

TEST_P(Displacement, OfAClipThatDoesNotLoopIsHeldAtItsEnds) {
  const RootMotion whole = displacement(curve(), 0, length(), false);
  EXPECT_EQ(distance(displacement(curve(), -length(), 50 * length(), false), whole), 0.0);
  EXPECT_EQ(distance(displacement(curve(), length(), 50 * length(), false), {}), 0.0);
  EXPECT_EQ(distance(displacement(curve(), 0, -length(), false), {}), 0.0);
  EXPECT_LT(distance(displacement(curve(), length(), 0, false), inverse(whole)), 1e-12);
}

TEST_P(Displacement, HasTheRootVelocityAsItsRate) {
  const FineTicks step = fine(1e-5);
  for (const double part : {0.02, 0.1, 0.35, 0.7, 0.98}) {
    const auto position = static_cast<FineTicks>(part * static_cast<double>(length()));
    const RootMotion moved = displacement(curve(), position, position + step, true);
    const RootVelocity velocity = root_velocity(curve(), position);
    EXPECT_LT(glm::distance(moved.translation / 1e-5, velocity.linear), 2e-3) << part;
    EXPECT_NEAR(moved.yaw / 1e-5, velocity.yaw, 1e-6) << part;
  }
}

TEST_P(Displacement, HasAVelocityAtBothEnds) {
  const FineTicks step = fine(1e-5);
  for (const FineTicks from : {FineTicks{0}, length() - step}) {
    const RootMotion moved = displacement(curve(), from, from + step, false);
    const RootVelocity velocity = root_velocity(curve(), from == 0 ? 0 : length());
    EXPECT_LT(glm::distance(moved.translation / 1e-5, velocity.linear), 2e-3);
    EXPECT_NEAR(moved.yaw / 1e-5, velocity.yaw, 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Curves, Displacement,
                         testing::Values(NamedCurve{"straight", straight_root_curve(second, {0.2, 0.0, 1.4})},
                                         NamedCurve{"bent_back", bent(0.0)}, NamedCurve{"turning", bent(0.7)},
                                         NamedCurve{"hardly_turning", bent(1e-9)}, NamedCurve{"half_a_turn", bent(-pi)},
                                         NamedCurve{"a_whole_turn", bent(2.0 * pi)},
                                         NamedCurve{"almost_two_turns", bent(4.0 * pi - 1e-7)}),
                         [](const auto& curve) { return curve.param.name; });

TEST(RootMotion, TurnsFromForwardsToTheLeft) {
  const RootMotion forwards{.translation = {0.0, 0.0, 1.0}};
  const RootMotion turned = compose({.yaw = pi / 2.0}, forwards);
  EXPECT_LT(glm::distance(turned.translation, glm::dvec3(1.0, 0.0, 0.0)), 1e-15) << "+X is the left of who faces +Z";
}

TEST(RootMotion, OfAClipThatStaysIsNone) {
  const RootCurve none = straight_root_curve(second, glm::dvec3(0.0));
  EXPECT_TRUE(none.keys.empty());
  EXPECT_EQ(distance(displacement(none, 0, fine(17.0), true), {}), 0.0);
  EXPECT_EQ(root_velocity(none, 0).linear, glm::dvec3(0.0));
}

TEST(SteadyCurve, OfAQuarterTurnALoopWalksASquare) {
  const RootCurve walk = steady_root_curve(second, {.linear = {0.0, 0.0, 2.0}, .yaw = 0.5 * pi});
  const FineTicks loop = walk.duration * fine_ticks_per_tick;
  const RootMotion side = displacement(walk, 0, loop, true);
  EXPECT_NEAR(side.yaw, 0.5 * pi, 1e-12);
  EXPECT_NEAR(glm::length(side.translation), 2.0 * std::sqrt(2.0) / (0.5 * pi), 1e-9) << "the chord of a quarter";
  RootMotion place;
  for (int corner = 1; corner <= 4; ++corner) {
    place = compose(place, side);
    EXPECT_LT(distance(place, displacement(walk, 0, corner * loop, true)), 1e-12);
  }
  EXPECT_LT(glm::length(place.translation), 1e-9) << "back where it began";
}

TEST(SteadyCurve, IsSteadyFromWhereverOneLooks) {
  const RootVelocity velocity{.linear = {0.3, 0.2, 1.4}, .yaw = -1.1};
  const RootCurve curve = steady_root_curve(3 * second, velocity);
  for (const double from : {0.0, 0.7, 1.9, 2.8}) {
    for (const double seconds : {0.1, 1.0, 7.3}) {
      const RootMotion moved = displacement(curve, fine(from), fine(from + seconds), true);
      EXPECT_LT(distance(moved, moved_by(velocity, seconds)), 1e-9) << from << " + " << seconds;
    }
    EXPECT_LT(glm::distance(root_velocity(curve, fine(from)).linear, velocity.linear), 1e-9);
  }
}

TEST(SteadyVelocity, LeadsToTheMotionItIsOf) {
  for (const double yaw : {0.0, 1e-12, 0.3, -2.0, 5.0}) {
    const RootMotion motion{.translation = {0.4, -0.3, 1.1}, .yaw = yaw};
    EXPECT_LT(distance(moved_by(steady_velocity(motion, 1.7), 1.7), motion), 1e-12);
  }
}

TEST(RootMotion, ThatIsRepeatedClimbsEachTime) {
  const RootMotion stairs{.translation = {0.1, 0.2, 0.5}, .yaw = 0.4};
  RootMotion twelve;
  for (int i = 0; i < 12; ++i) twelve = compose(twelve, stairs);
  EXPECT_LT(distance(power(stairs, 12.0), twelve), 1e-12);
  EXPECT_NEAR(power(stairs, -5.0).translation.y, -1.0, 1e-12);
}

TEST(RootMotion, OfADayOfWalkingIsExactToAMicrometre) {
  const RootCurve walk = straight_root_curve(second, {0.0, 0.0, 1.4});
  const double day = 24.0 * 3600.0;
  EXPECT_NEAR(displacement(walk, 0, fine(day), true).translation.z, 1.4 * day, 1e-6);
}

}  // namespace
}  // namespace throng::anim::root_curve_test
