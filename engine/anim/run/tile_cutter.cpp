#include "engine/anim/run/tile_cutter.h"

#include <algorithm>
#include <cassert>

#include "engine/anim/run/fused/scratch.h"

namespace throng::anim {
namespace {

/// The needs of the newest tile, and how many characters they let it have.
class NewestTile {
 public:
  NewestTile(const LocalStorePlan& plan, Schedule schedule) : plan_(plan), schedule_(schedule) {}

  std::uint32_t limit() const { return static_cast<std::uint32_t>(fit_.characters); }
  std::uint32_t width() const { return static_cast<std::uint32_t>(fit_.width); }
  const StoreNeeds& needs() const { return needs_; }

  /// Returns true if characters of this program need no more than the characters of the tile.
  bool holds(const PoseProgram& program) const {
    StoreNeeds wider = needs_;
    wider.widen(program.needs);
    return program.needs.shared == 0 && wider == needs_;
  }
  void begin(const UpdateContext& context, const PoseProgram& program) {
    needs_ = program.needs;
    shared_ = {};
    shared_.add(program);
    fit_ = fit_for(context, needs_, shared_);
    assert(fit_.characters > 0 && "a program that does not fit the local store was let in");
  }
  /// Makes room for this program beside `count` characters. False: there is none, and nothing was changed.
  bool widen(const UpdateContext& context, const PoseProgram& program, std::uint32_t count) {
    StoreNeeds wider = needs_;
    wider.widen(program.needs);
    SharedSources more = shared_;
    if (!more.add(program)) return false;
    const FusedFit fit = fit_for(context, wider, more);
    if (static_cast<std::uint32_t>(fit.characters) <= count) return false;
    needs_ = wider;
    shared_ = more;
    fit_ = fit;
    return true;
  }

 private:
  FusedFit fit_for(const UpdateContext& context, const StoreNeeds& needs, const SharedSources& shared) const {
    if (schedule_ == Schedule::levels) return {.width = plan_.width, .characters = plan_.width};
    return fused_fit(context, needs, shared.bytes(*context.pools), plan_);
  }

  const LocalStorePlan& plan_;
  Schedule schedule_;
  StoreNeeds needs_;
  SharedSources shared_;
  FusedFit fit_;
};

void add_characters(Tile& tile, const AgentWork& like, std::uint32_t count) {
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
      tiles_.back().width = newest.width();
    }
    if (next == run.count) continue;
    // A narrow agent narrows its own tile only; the tiles after it take the width that their agents allow.
    if (!holds || newest.needs() != like.program->needs) newest.begin(context, *like.program);
    for (; next < run.count; next += tiles_.back().count) {
      tiles_.push_back({.first = run.first + next, .width = newest.width(), .needs = newest.needs()});
      add_characters(tiles_.back(), like, std::min(newest.limit(), run.count - next));
    }
  }
}

/// Two runs of the work that differ in cost alone are one in a tile.
void TileCutter::find_runs_of_tiles(const WorkOrder& order) {
  runs_.clear();
  auto run = order.runs().begin();
  for (Tile& tile : tiles_) {
    tile.first_run = static_cast<std::uint32_t>(runs_.size());
    for (std::uint32_t next = 0; next < tile.count;) {
      while (run->first + run->count <= tile.first + next) ++run;
      const PoseProgram* program = order.work()[run->first].program;
      const std::uint32_t end = std::min(run->first + run->count - tile.first, tile.count);
      if (next > 0 && runs_.back().program == program) {
        runs_.back().count += end - next;
      } else {
        runs_.push_back({program, next, end - next});
      }
      next = end;
    }
    tile.run_count = static_cast<std::uint32_t>(runs_.size()) - tile.first_run;
  }
}

// Returns the sum of all costs.
double TileCutter::add_overheads(std::span<const UpdateContext> contexts, std::span<const AgentWork> work,
                                 const CostModel& cost) {
  double total = 0;
  for (Tile& tile : tiles_) {
    const AgentWork& first = work[tile.first];
    tile.cost += static_cast<float>(tile.strips() * cost.of_tile(contexts[first.skeleton].packets(first.level)));
    total += static_cast<double>(tile.cost);
  }
  return total;
}

// Cuts a tile in two behind so many agents; `overhead` is a strip's.
void TileCutter::divide(std::size_t tile, std::uint32_t kept, double overhead) {
  Tile& left = tiles_[tile];
  const double agent = (static_cast<double>(left.cost) - left.strips() * overhead) / left.count;
  Tile right = left;
  right.first += kept;
  right.count -= kept;
  left.count = kept;
  for (Tile* part : {&left, &right}) part->cost = static_cast<float>(part->strips() * overhead + part->count * agent);
  tiles_.insert(tiles_.begin() + static_cast<std::ptrdiff_t>(tile) + 1, right);
}

// Returns how many agents of a tile of one strip cost about `wanted`.
std::uint32_t TileCutter::agents_for(const Tile& tile, double wanted, double overhead) {
  const double agent = (static_cast<double>(tile.cost) - overhead) / tile.count;
  const double fits = (wanted - overhead) / agent;
  return static_cast<std::uint32_t>(std::clamp(fits + 0.5, 1.0, static_cast<double>(tile.count) - 1));
}

CutWork TileCutter::cut(std::span<const UpdateContext> contexts, const WorkOrder& order, const LocalStorePlan& plan,
                        Schedule schedule, const CostModel& cost, std::span<int> shares) {
  const std::span<const AgentWork> work = order.work();
  cut_full_width(contexts, order, plan, schedule);
  const double total = add_overheads(contexts, work, cost);
  const auto share_count = shares.size() - 1;
  const double share_cost = total / static_cast<double>(share_count);
  double before = 0;
  std::size_t share = 1;
  for (std::size_t tile = 0; tile < tiles_.size() && share < share_count;) {
    const double wanted = share_cost * static_cast<double>(share) - before;
    const auto whole = static_cast<double>(tiles_[tile].cost);
    const AgentWork& first = work[tiles_[tile].first];
    const double overhead = cost.of_tile(contexts[first.skeleton].packets(first.level));
    if (wanted <= whole) {
      if (tiles_[tile].strips() > 1) {
        divide(tile, tiles_[tile].width, overhead);
        continue;
      }
      ++share;
      if (tiles_[tile].count > 1 && std::min(wanted, whole - wanted) > overhead) {
        divide(tile, agents_for(tiles_[tile], wanted, overhead), overhead);
      }
    }
    before += static_cast<double>(tiles_[tile++].cost);
  }
  find_runs_of_tiles(order);
  cut_shares(
      static_cast<int>(tiles_.size()),
      [this](int tile) { return static_cast<double>(tiles_[static_cast<std::size_t>(tile)].cost); }, shares);
  return {tiles_, runs_};
}

int pus_worth_waking(double nanoseconds, int pus, const CostModel& cost) {
  return std::clamp(static_cast<int>(std::min(nanoseconds / cost.least_task, 1e6)), 1, pus);
}

}  // namespace throng::anim
