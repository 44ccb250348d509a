#pragma once

#include <span>
#include <vector>

#include "engine/anim/base/room.h"
#include "engine/anim/run/local_store_plan.h"
#include "engine/anim/run/program/agent_work.h"
#include "engine/anim/run/program/cost_model.h"
#include "engine/anim/run/program/shared_sources.h"
#include "engine/anim/run/program/tile.h"
#include "engine/anim/run/program/work_order.h"

namespace throng::anim {

/// Cuts the work of a frame into tiles, and tiles into shares for PUs, by their predicted cost (paper 3.2).
class TileCutter {
 public:
  /// Makes room for so many agents, so that cut() does not allocate.
  void reserve(std::size_t agents) {
    make_room(tiles_, agents);
    make_room(runs_, agents);
  }

  /// Cuts tiles as wide as the plan lets them be, and once more where a share ends so that no PU is late. `shares` gets
  /// the first tile of each share and, last, the number of tiles. The result is there until the next call.
  CutWork cut(std::span<const UpdateContext> contexts, const WorkOrder& order, const LocalStorePlan& plan,
              Schedule schedule, const CostModel& cost, std::span<int> shares);

 private:
  void cut_full_width(std::span<const UpdateContext> contexts, const WorkOrder& order, const LocalStorePlan& plan,
                      Schedule schedule);
  double add_overheads(std::span<const UpdateContext> contexts, std::span<const AgentWork> work, const CostModel& cost);
  void divide(std::size_t tile, std::uint32_t kept, double overhead);
  void find_runs_of_tiles(const WorkOrder& order);
  static std::uint32_t agents_for(const Tile& tile, double wanted, double overhead);

  std::vector<Tile> tiles_;
  std::vector<AgentRun> runs_;
};

/// Cuts tasks 0 to count - 1 into shares of about equal cost. `firsts` gets the first task of each share, and then
/// `count`. A task lies in the share in which most of it does. `cost_of(task)` may have any unit.
template <typename CostOf>
void cut_shares(int count, CostOf&& cost_of, std::span<int> firsts) {
  double total = 0;
  for (int task = 0; task < count; ++task) total += cost_of(task);
  const auto shares = static_cast<double>(firsts.size() - 1);
  std::size_t share = 0;
  double before = 0;
  for (int task = 0; task < count; ++task) {
    const double cost = cost_of(task);
    while (share + 1 < firsts.size() && before + cost / 2 >= total * static_cast<double>(share) / shares) {
      firsts[share++] = task;
    }
    before += cost;
  }
  while (share < firsts.size()) firsts[share++] = count;
}

/// Returns how many of `pus` are worth waking for work of so many nanoseconds: at least one.
int pus_worth_waking(double nanoseconds, int pus, const CostModel& cost);

}  // namespace throng::anim
