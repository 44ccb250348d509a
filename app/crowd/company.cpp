#include "app/crowd/company.h"

#include <numeric>

#include "app/crowd/layout.h"
#include "app/crowd/numbers/random.h"

namespace throng::app {
namespace {

constexpr std::uint64_t company_stream = 26;
constexpr float share_with_company = 0.35F, share_of_threes = 0.3F;  // of those who lead
constexpr float to_the_side = 0.68F;                                 // metres

}  // namespace

void draw_company(CrowdLayout& layout, std::uint32_t seed) {
  if (layout.walkers_habit != Habit::stroll) return;
  Company& company = layout.company;
  company = {.leaders = std::vector<std::uint32_t>(layout.walkers.size()),
             .sides = std::vector<float>(layout.walkers.size())};
  std::iota(company.leaders.begin(), company.leaders.end(), 0U);
  Random random(seed, company_stream);
  const auto on_lane_of = [&](std::size_t leader, std::size_t walker) {
    return walker < layout.walkers.size() && layout.walkers[walker].lane == layout.walkers[leader].lane;
  };
  for (std::size_t leader = 0; leader < layout.walkers.size();) {
    const bool has_company = random.chance(share_with_company), are_three = random.chance(share_of_threes);
    const std::size_t others = has_company ? (are_three ? 2 : 1) : 0;
    std::size_t next = leader + 1;
    for (std::size_t other = 0; other < others && on_lane_of(leader, next); ++other, ++next) {
      company.leaders[next] = static_cast<std::uint32_t>(leader);
      company.sides[next] =
          other == 0 ? to_the_side : -to_the_side;  // the first on the left, where a hand leads a child
      layout.walkers[next].distance = layout.walkers[leader].distance;
    }
    leader = next;
  }
}

}  // namespace throng::app
