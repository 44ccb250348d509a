#include "engine/anim/run/tile_cutter.h"

#include <algorithm>
#include <cassert>

#include "engine/anim/run/fused_scratch.h"

namespace throng::anim {
namespace {

/// What the newest tile asks of the store, and how wide that lets it be.
class NewestTile {
 public:
  NewestTile(const LocalStorePlan& plan, Schedule schedule) : plan_(plan), schedule_(schedule) {}

  std::uint32_t limit() const { return limit_; }
  const StoreNeeds& needs() const { return needs_; }

  /// Room for its characters is room for those of this program, too.
  bool holds(const PoseProgram& program) const {
    StoreNeeds wider = needs_;
    wider.widen(program.needs);
    return program.needs.shared == 0 && wider == needs_;
  }
  void begin(const UpdateContext& context, const PoseProgram& program) {
    needs_ = program.needs;
    shared_ = {};
    shared_.add(program);
    limit_ = limit_for(context, needs_, shared_);
    assert(limit_ > 0 && "a program that does not fit the local store was let in");
  }
  /// Makes room for this program beside `count` characters. False: there is none, and nothing was changed.
  bool widen(const UpdateContext& context, const PoseProgram& program, std::uint32_t count) {
    StoreNeeds wider = needs_;
    wider.widen(program.needs);
    SharedSources more = shared_;
    const std::uint32_t limit = more.add(program) ? limit_for(context, wider, more) : 0;
    if (limit <= count) return false;
    needs_ = wider;
    shared_ = more;
    limit_ = limit;
    return true;
  }

 private:
  std::uint32_t limit_for(const UpdateContext& context, const StoreNeeds& needs, const SharedSources& shared) const {
    int width = plan_.width;
    if (schedule_ == Schedule::fused) {
      width = std::min(width, widest_fused_tile(context, needs, shared.bytes(*context.pools), plan_));
    }
    return static_cast<std::uint32_t>(width);
  }

  const LocalStorePlan& plan_;
  Schedule schedule_;
  StoreNeeds needs_;
  SharedSources shared_;
  std::uint32_t limit_ = 0;
};

void add_characters(Tile& tile, const AgentWork& like, std::uint32_t count) {
  if (tile.count > 0 && tile.program != like.program) tile.program = nullptr;
  tile.count += count;
  tile.cost += static_cast<float>(count * like.cost * cost_step);
}

}  // namespace

void TileCutter::cut_full_width(std::span<const UpdateContext> contexts, const WorkOrder& order,
                                const LocalStorePlan& plan, Schedule schedule) {
  const std::span<const AgentWork> work = order.work();
  tiles_.clear();
  NewestTile newest(plan, schedule);
  for (const WorkRun& run : order.runs()) {
    const AgentWork& like = work[run.first];
    const UpdateContext& context = contexts[like.skeleton];
    const bool joins = run.first > 0 && share_a_tile(work[run.first - 1], like);
    const bool holds = joins && newest.holds(*like.program);
    std::uint32_t next = 0;
    if (holds || (joins && newest.widen(context, *like.program, tiles_.back().count))) {
      next = std::min(newest.limit() - tiles_.back().count, run.count);
      if (next > 0) add_characters(tiles_.back(), like, next);
      tiles_.back().needs = newest.needs();
    }
    if (next == run.count) continue;
    if (!holds) newest.begin(context, *like.program);
    for (; next < run.count; next += tiles_.back().count) {
      tiles_.push_back({.first = run.first + next, .program = like.program, .needs = newest.needs()});
      add_characters(tiles_.back(), like, std::min(newest.limit(), run.count - next));
    }
  }
}

// The sum of all.
double TileCutter::add_overheads(std::span<const UpdateContext> contexts, std::span<const AgentWork> work,
                                 const CostModel& cost) {
  double total = 0;
  for (Tile& tile : tiles_) {
    const AgentWork& first = work[tile.first];
    tile.cost += static_cast<float>(cost.of_tile(contexts[first.skeleton].packets(first.level)));
    total += static_cast<double>(tile.cost);
  }
  return total;
}

// In two, so that the first costs about `wanted`; both keep the overhead of a tile.
void TileCutter::divide(std::size_t tile, double wanted, double overhead) {
  Tile& left = tiles_[tile];
  const double agent = (static_cast<double>(left.cost) - overhead) / left.count;
  const double fits = (wanted - overhead) / agent;
  const auto kept = static_cast<std::uint32_t>(std::clamp(fits + 0.5, 1.0, static_cast<double>(left.count) - 1));
  const std::uint32_t moved = left.count - kept;
  const Tile right{.first = left.first + kept,
                   .count = moved,
                   .cost = static_cast<float>(overhead + moved * agent),
                   .program = left.program,
                   .needs = left.needs};
  left.count = kept;
  left.cost = static_cast<float>(overhead + kept * agent);
  tiles_.insert(tiles_.begin() + static_cast<std::ptrdiff_t>(tile) + 1, right);
}

std::span<const Tile> TileCutter::cut(std::span<const UpdateContext> contexts, const WorkOrder& order,
                                      const LocalStorePlan& plan, Schedule schedule, const CostModel& cost,
                                      std::span<int> shares) {
  const std::span<const AgentWork> work = order.work();
  cut_full_width(contexts, order, plan, schedule);
  const double total = add_overheads(contexts, work, cost);
  const auto share_count = shares.size() - 1;
  const double share_cost = total / static_cast<double>(share_count);
  double before = 0;
  std::size_t share = 1;
  for (std::size_t tile = 0; tile < tiles_.size() && share < share_count; ++tile) {
    const double wanted = share_cost * static_cast<double>(share) - before;
    const auto whole = static_cast<double>(tiles_[tile].cost);
    if (wanted > whole) {
      before += whole;
      continue;
    }
    ++share;
    const AgentWork& first = work[tiles_[tile].first];
    const double overhead = cost.of_tile(contexts[first.skeleton].packets(first.level));
    if (tiles_[tile].count > 1 && std::min(wanted, whole - wanted) > overhead) divide(tile, wanted, overhead);
    before += static_cast<double>(tiles_[tile].cost);
  }
  cut_shares(
      static_cast<int>(tiles_.size()),
      [this](int tile) { return static_cast<double>(tiles_[static_cast<std::size_t>(tile)].cost); }, shares);
  return tiles_;
}

int pus_worth_waking(double nanoseconds, int pus, const CostModel& cost) {
  return std::clamp(static_cast<int>(std::min(nanoseconds / cost.least_task, 1e6)), 1, pus);
}

}  // namespace throng::anim
