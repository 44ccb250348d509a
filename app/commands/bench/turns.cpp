#include "app/commands/bench/turns.h"

#include <map>
#include <span>
#include <string>
#include <utility>

#include "app/commands/bench/case.h"
#include "app/files/exit_status.h"
#include "app/files/memory_check.h"
#include "app/show/stage/memory_needs.h"

namespace throng::app {
namespace {

/// Enough rounds to make the start of a pass, crowds and memory, small beside them.
constexpr int rounds_of_a_pass = 4;

/// Makes each character once, by bones and clips; a model brings its own.
class BenchCharacters {
 public:
  Result<const BenchCharacter*> of(const BenchOptions& options, const BenchCase& bench) {
    const auto key = options.model.empty() ? std::pair(bench.bones, bench.clips) : std::pair(0, 0);
    auto found = made_.find(key);
    if (found == made_.end()) {
      auto made = bench_character(options, bench.bones, bench.clips);
      if (!made) return made.error();
      found = made_.emplace(key, std::move(*made)).first;
    }
    return &found->second;
  }

 private:
  std::map<std::pair<int, int>, BenchCharacter> made_;
};

std::string label_of(std::size_t pass, std::size_t passes, std::size_t index, std::span<const BenchCase> cases) {
  if (cases.size() == 1) return "";
  return "pass " + std::to_string(pass + 1) + " of " + std::to_string(passes) + ", " + std::to_string(index + 1) +
         " of " + std::to_string(cases.size()) + ": " + std::to_string(cases[index].agents) + " agents, " +
         std::to_string(cases[index].bones) + " bones, ";
}

/// A row's time by agent and bone over the first row's, round by round.
double over_first_row(std::span<const Json> rows, std::span<const BenchTimes> times) {
  const auto bones = [](const Json& row) { return row["agents"].get<double>() * row["bones_per_agent"].get<double>(); };
  const std::size_t row = rows.size() - 1;
  return times[row].median_ratio("update", times[0], "update") * bones(rows[0]) / bones(rows[row]);
}

}  // namespace

std::vector<BenchCase> bench_cases(const BenchOptions& options) {
  std::vector<BenchCase> cases;
  for (const int bones : options.bones)
    for (const int clips : options.clips)
      for (const int agents : options.agents)
        for (const int pus : options.pus)
          for (const anim::Schedule schedule : options.schedules)
            for (const anim::StreamKind stream : options.streams)
              cases.push_back({agents, bones, clips, pus, schedule, stream});
  return cases;
}

// Measured with 100,000 agents of 62 bones, and 50,000 of 1024.
Status check_memory(const BenchOptions& options, const BenchCase& bench, const BenchCharacter& character) {
  constexpr std::uint64_t bytes_an_agent = 8000, bytes_a_bone = 360;
  const auto bones = static_cast<std::uint64_t>(character.character->skeleton.bone_count());
  const std::uint64_t crowd = static_cast<std::uint64_t>(bench.agents) * (bytes_an_agent + bones * bytes_a_bone);
  return check_memory(std::to_string(bench.agents) + " agents of " + std::to_string(bones) + " bones, and their PUs,",
                      crowd + bytes_of_pus(bench_system_options(options, bench)), "ask for fewer");
}

std::vector<int> rounds_of_passes(int rounds, std::size_t cases) {
  const int passes = cases == 1 ? 1 : (rounds + rounds_of_a_pass - 1) / rounds_of_a_pass;
  std::vector<int> result;
  result.reserve(static_cast<std::size_t>(passes));
  for (int pass = 0; pass < passes; ++pass) {
    result.push_back(rounds / passes + (pass < rounds % passes ? 1 : 0));
  }
  return result;
}

std::optional<int> run_cases(const BenchOptions& options, std::vector<Json>& rows, std::optional<TimelineLog>& trace) {
  const std::vector<BenchCase> cases = bench_cases(options);
  const std::vector<int> rounds = rounds_of_passes(options.frames, cases.size());
  BenchCharacters characters;
  std::vector<BenchTimes> times(cases.size());
  for (std::size_t pass = 0; pass < rounds.size(); ++pass) {
    const bool is_last = pass + 1 == rounds.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const auto character = characters.of(options, cases[i]);
      if (!character) return end_with(character);
      const Status fits = check_memory(options, cases[i], **character);
      if (!fits) return end_with(fits);
      auto row = run_bench_case(options, cases[i], **character,
                                {rounds[pass], is_last, label_of(pass, rounds.size(), i, cases)}, times[i], trace);
      if (!row) return end_with(exit_usage, row.error().message);
      if (!is_last) continue;
      rows.push_back(std::move(*row));
      if (cases.size() > 1) rows.back()["ns_per_bone_over_first_row"] = over_first_row(rows, times);
    }
  }
  return {};
}

}  // namespace throng::app
