#include "tests/soak/program_rounds.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include <nlohmann/json.hpp>

#include "throng/render/context.h"

#include "tests/sanitized.h"

namespace throng::soak {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

Json json_in(const fs::path& file) {
  std::ifstream stream(file);
  return Json::parse(stream, nullptr, false);
}

bool is_given(const Words& words, const std::string& option) {
  return std::ranges::any_of(words, [&](const std::string& word) { return word.starts_with(option); });
}

/// Returns whether a text is one line of the program.
bool is_one_line(const std::string& text) {
  return text.starts_with("throng: ") && std::ranges::count(text, '\n') == 1 && text.ends_with('\n');
}

/// Returns whether somebody else than the program speaks, such as the library of a misuse, or a sanitizer.
bool has_strange_line(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("throng: ") || line.find("::") < line.find(' ', 8))
      return true;  // AnimationSystem::advance: ...
  }
  return false;
}

/// Compares what must be equal in two statistics of the same run.
Fault difference(const Json& one, const Json& other, std::initializer_list<const char*> keys) {
  for (const char* const key : keys) {
    if (!one.contains(key) || !other.contains(key)) return std::string("the statistics have no ") + key;
    if (one[key] != other[key]) return std::string(key) + " is " + one[key].dump() + ", then " + other[key].dump();
  }
  return {};
}

/// Returns whether a number is missing: one that is none is written as null.
bool has_null(const Json& json) {
  if (json.is_null() || json.is_discarded()) return true;
  return json.is_structured() && std::ranges::any_of(json, has_null);
}

}  // namespace

Fault ProgramRounds::run(const RoundPlace& place) {
  Random random(place.seed, 1);
  const std::uint32_t which = random.below(10);
  if (which < 6) return record_and_replay(place, random);
  if (which < 8) return play_a_pack(place, random);
  return which < 9 ? run_a_tool(place, random) : run_for_long(place, random);
}

Fault ProgramRounds::run(const Words& words, const RoundPlace& place, ProgramRun& run, bool must_work) {
  tell(as_command(words));
  run = run_program(words, place.folder);
  const std::string asked = as_command(words) + "\n  ";
  if (run.hung) return asked + "hangs";
  if (run.status >= 128) return asked + "ends with signal " + std::to_string(run.status - 128) + ": " + run.errors;
  if (run.status == 0) return has_strange_line(run.errors) ? asked + "says " + run.errors : Fault{};
  if (!is_one_line(run.errors)) return asked + "ends with " + std::to_string(run.status) + " and says: " + run.errors;
  tell("  " + run.errors);
  if (must_work) return asked + "is refused: " + run.errors;
  ++counts_["refused, exit status " + std::to_string(run.status)];
  return {};
}

// A tile may be too large for the local store, which is exit status 2; then it runs as it is scheduled without a word.
Fault ProgramRounds::run_scheduled(const Words& words, const Words& scheduling, const RoundPlace& place,
                                   ProgramRun& run) {
  Words all = words;
  all.insert(all.end(), scheduling.begin(), scheduling.end());
  if (Fault fault = this->run(all, place, run, !is_given(all, "--tile"))) return fault;
  return run.status == 2 ? this->run(words, place, run, true) : Fault{};
}

Fault ProgramRounds::replay(const RoundPlace& place, Random& random) {
  const Json recorded = json_in(place.folder / "stats.json");
  Words words = {"--headless=none", "--replay", "run.rec", "--stats", "again.json"};
  if (recorded.contains("events") && !recorded["events"].is_null()) words.push_back("--events");
  ProgramRun again;
  if (Fault fault = run_scheduled(words, any_scheduling(random), place, again)) return fault;
  ++counts_["replays"];
  const Fault differs = difference(recorded, json_in(place.folder / "again.json"),
                                   {"pose_hash", "agents", "frames", "event_hash", "place_hash", "events"});
  return differs ? as_command(words) + "\n  repeats something else: " + *differs : Fault{};
}

Fault ProgramRounds::record_and_replay(const RoundPlace& place, Random& random) {
  const Words words = any_demo_line(*models_, place.folder, random);
  ProgramRun first;
  if (Fault fault = run(words, place, first, false)) return fault;
  ++counts_["lines of the demo"];
  if (first.status != 0) return {};
  const Json stats = json_in(place.folder / "stats.json");
  if (!stats.is_object()) return as_command(words) + "\n  wrote no statistics";
  if (is_given(words, "--screenshot") && !fs::exists(place.folder / "picture.png"))
    return as_command(words) + "\n  wrote no picture";
  if (Fault fault = replay(place, random)) return as_command(words) + "\n" + *fault;
  return {};
}

// A crowd from a pack with keys plays as one from the files that the pack is made of.
Fault ProgramRounds::play_a_pack(const RoundPlace& place, Random& random) {
  Words models;
  for (std::uint32_t left = 1 + random.below(3); left > 0; --left) models.push_back(any_model(*models_, random));
  Words bake = {"bake"};
  bake.insert(bake.end(), models.begin(), models.end());
  bake.insert(bake.end(), {"--keep-keys", "-o", "town.pack"});
  ProgramRun run;
  if (Fault fault = this->run(bake, place, run, false)) return fault;
  ++counts_["packs"];
  if (run.status != 0) return {};
  Words rest = {"--headless=none",
                "--agents",
                std::to_string(1 + random.below(300)),
                "--frames",
                std::to_string(1 + random.below(60)),
                "--stats",
                "stats.json",
                "--events"};
  Words from_files = models, from_pack = {"town.pack"};
  from_files.insert(from_files.end(), rest.begin(), rest.end());
  rest[6] = "again.json";
  from_pack.insert(from_pack.end(), rest.begin(), rest.end());
  if (Fault fault = this->run(from_files, place, run, true)) return fault;
  if (Fault fault = run_scheduled(from_pack, any_scheduling(random), place, run)) return fault;
  const Fault differs = difference(json_in(place.folder / "stats.json"), json_in(place.folder / "again.json"),
                                   {"pose_hash", "event_hash", "place_hash"});
  return differs ? as_command(bake) + "\n" + as_command(from_files) + "\n" + as_command(from_pack) +
                       "\n  differ: " + *differs
                 : Fault{};
}

Fault ProgramRounds::run_a_tool(const RoundPlace& place, Random& random) {
  const std::string model = any_model(*models_, random);
  const std::array<Words, 4> tools = {
      Words{"pose", model, "--clip", random.chance(0.5F) ? "0" : "none", "--time", "0,0.1,0.77,12", "--json",
            "pose.json"},
      Words{"inspect", model, "--json"}, Words{"lod", model, "--json", "lod.json", "--export", "levels.json"},
      Words{"bench", model, "--agents", "10,200", "--frames", "2", "--json", "bench.json"}};
  const std::size_t which = random.below(static_cast<std::uint32_t>(tools.size()));
  ProgramRun run;
  if (Fault fault = this->run(tools[which], place, run, false)) return fault;
  ++counts_["other commands"];
  const bool posed = which == 0 && run.status == 0;
  if (posed && has_null(json_in(place.folder / "pose.json")["samples"]))  // without a clip, "clip" is null
    return as_command(tools[which]) + "\n  wrote a number that is none";
  return {};
}

// One process plays on, until Ctrl+C. In its second half it takes no more memory, files and threads than in its first.
Fault ProgramRounds::run_for_long(const RoundPlace& place, Random& random) {
  Words words = {"--frames",
                 "2000000000",
                 "--stats",
                 "stats.json",
                 "--record",
                 "run.rec",
                 "--headless=" +
                     any_of(random, Words{"none", "none", "egl", render::gl::osmesa_is_installed() ? "osmesa" : "egl"}),
                 "--size",
                 "320x240",
                 "--agents",
                 std::to_string(100 + random.below(400)),
                 "--scene",
                 any_of(random, Words{"plaza", "parade", "stadium", "grid", "film"})};
  if (!words[6].ends_with("none")) words.insert(words.end(), {"--draw", "all"});
  tell(as_command(words));
  constexpr double warm_up = 5, until_interrupt = 15;  // seconds of computing
  const ProgramRun run = run_program(words, place.folder, {.until_interrupt = until_interrupt, .until_killed = 900});
  ++counts_["long runs"];
  const std::string asked = as_command(words) + "\n  ";
  if (run.hung || run.status != 130)
    return asked + "ends with " + std::to_string(run.status) + " after Ctrl+C: " + run.errors;
  // The software renderer keeps what it has compiled and scenes of its own, up to a limit that takes minutes to reach.
  const bool draws = is_given(words, "--draw");
  const std::uint64_t slack = (draws ? 64 : 4) * mebibyte;
  ProcessFigures before, after;
  for (const ProcessFigures& figures : run.figures) {
    if (figures.computed < warm_up || figures.computed > until_interrupt) continue;
    ProcessFigures& largest = figures.computed < (warm_up + until_interrupt) / 2 ? before : after;
    largest.resident = std::max(largest.resident, figures.resident);
    largest.descriptors = std::max(largest.descriptors, figures.descriptors);
    largest.threads = std::max(largest.threads, figures.threads);
  }
  tell("  resident " + std::to_string(before.resident) + ", then " + std::to_string(after.resident) + " bytes");
  if (!test::sanitized && after.resident > before.resident + slack)
    return asked + "grows from " + std::to_string(before.resident) + " to " + std::to_string(after.resident) + " bytes";
  if (after.descriptors > before.descriptors) return asked + "opens more and more files";
  if (after.threads > before.threads) return asked + "makes more and more threads";
  return {};
}

}  // namespace throng::soak
