#include "app/commands/lod/curve.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>

#include "app/commands/bench/crowd.h"
#include "app/commands/bench/plot.h"
#include "app/commands/bench/report.h"
#include "app/commands/bench/rounds.h"
#include "engine/base/json/json.h"

namespace throng::app {
namespace {

constexpr int timed_agents = 1000;
constexpr int timed_rounds = 40;
constexpr double worth_a_switch = 0.9;    // of the time of the level before
constexpr double least_pixels_tall = 10;  // smaller characters are dots, whatever their bones
constexpr int agents_of_milliseconds = 10'000;

std::string key_of(std::size_t level) { return "level " + std::to_string(level); }

double pixels_of(const CharacterSource& source, const LodLevel& level, int pixels) {
  return source.character->bounds.height > 0.0 ? level.error_metres / source.character->bounds.height * pixels : 0.0;
}

/// JSON has no infinity.
Json within(double value) { return std::isfinite(value) ? Json(value) : Json(); }

double milliseconds_of(const LodLevel& level) { return level.nanoseconds * agents_of_milliseconds / 1e6; }

std::vector<Json> rows_of(const CharacterSource& source, std::span<const LodLevel> levels, int pixels) {
  std::vector<Json> rows;
  const std::vector<bool> pays = levels_that_pay(levels, source.character->bounds.height);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const LodLevel& level = levels[i];
    rows.push_back({{"level", i},
                    {"bones", level.bones},
                    {"ns_per_agent", level.nanoseconds},
                    {"ms_10k_agents", milliseconds_of(level)},
                    {"error_mm", level.error_metres * 1000},
                    {"error_px", pixels_of(source, level, pixels)},
                    {"px_tall_for_1_px", within(pixels_tall_for_one_pixel(level, source.character->bounds.height))},
                    {"pays", pays[i] ? "yes" : "no"}});
  }
  return rows;
}

std::vector<Json> mesh_rows_of(const CharacterSource& source, std::span<const MeshLevel> meshes, int pixels) {
  const double height = source.character->bounds.height;
  std::vector<Json> rows;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const auto error = static_cast<double>(meshes[i].error.surface);
    rows.push_back({{"mesh_level", i},
                    {"triangles", meshes[i].triangles},
                    {"error_mm", error * 1000},
                    {"face_error_mm", static_cast<double>(meshes[i].error.face) * 1000},
                    {"error_px", height > 0.0 ? error / height * pixels : 0.0},
                    {"px_tall_for_1_px", error > 0.0 ? Json(height / error) : Json()}});
  }
  return rows;
}

/// Sentences that the table does not hold.
std::vector<std::string> remarks_on(const CharacterSource& source, std::span<const LodLevel> levels) {
  std::vector<std::string> remarks;
  if (levels.size() == 1) {
    remarks.emplace_back("Per-bone level of detail does not pay: no order of these bones has a level worth a switch.");
  }
  const std::vector<bool> pays = levels_that_pay(levels, source.character->bounds.height);
  std::size_t last = 0;
  for (std::size_t i = 1; i < levels.size(); ++i) {
    if (pays[i]) {
      last = i;
      continue;
    }
    char text[200];
    std::snprintf(text, sizeof(text),
                  "Level %zu does not pay: it takes %.0f%% of the time of level %zu, and is within a pixel only of "
                  "characters below %.2g pixels.",
                  i, 100 * levels[i].nanoseconds / levels[last].nanoseconds, last,
                  pixels_tall_for_one_pixel(levels[i], source.character->bounds.height));
    remarks.emplace_back(text);
  }
  if (source.model.clips.empty())
    remarks.emplace_back("The model has no clips, so nothing shows what its bones are for.");
  return remarks;
}

}  // namespace

Status time_levels(const CharacterSource& source, std::vector<LodLevel>& levels) {
  const std::vector<BenchAgent> agents = bench_agents(*source.character, timed_agents);
  const BenchPalettes palettes(timed_agents, source.character->skeleton.palette_count());
  auto subject = SystemSubject::create(source.character, {.pus = 1, .hash = false}, agents, palettes);
  if (!subject) return subject.error();
  anim::AnimationSystem& system = subject->system();
  BenchRounds rounds;
  std::vector<PoseRequest> updates(agents.size());
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const auto update = [&system, &updates] {
      system.advance(ticks_per_second / 60);
      system.update(updates);
    };
    const auto choose = [&updates, &palettes, level] {
      for (std::uint32_t agent = 0; agent < updates.size(); ++agent) {
        updates[agent] = {.agent = {agent}, .level = static_cast<std::uint8_t>(level), .palette = palettes.of(agent)};
      }
    };
    rounds.add({key_of(level), update, choose});
  }
  rounds.run(timed_rounds, source.name + ", ");
  for (std::size_t level = 0; level < levels.size(); ++level) {
    levels[level].nanoseconds = rounds.times().median(key_of(level)) / timed_agents;
  }
  return Done{};
}

double pixels_tall_for_one_pixel(const LodLevel& level, double height_metres) {
  return level.error_metres > 0.0 ? height_metres / level.error_metres : std::numeric_limits<double>::infinity();
}

std::vector<bool> levels_that_pay(std::span<const LodLevel> levels, double height_metres) {
  std::vector<bool> pays;
  double last = 0;
  for (const LodLevel& level : levels) {
    const bool saves = level.nanoseconds <= worth_a_switch * last;
    pays.push_back(pays.empty() || (saves && pixels_tall_for_one_pixel(level, height_metres) >= least_pixels_tall));
    if (pays.back()) last = level.nanoseconds;
  }
  return pays;
}

std::string curve_as_text(const CharacterSource& source, const LodCurve& curve, int pixels) {
  constexpr std::array columns = {"level",    "bones",    "ns_per_agent",     "ms_10k_agents",
                                  "error_mm", "error_px", "px_tall_for_1_px", "pays"};
  constexpr std::array mesh_columns = {"mesh_level",    "triangles", "error_mm",
                                       "face_error_mm", "error_px",  "px_tall_for_1_px"};
  char title[80];
  std::snprintf(title, sizeof(title), ", %.2f m; errors at p99, in pixels of one %d pixels tall\n",
                source.character->bounds.height, pixels);
  std::string text = source.name + title + figures_as_text(rows_of(source, curve.bones, pixels), columns);
  text += figures_as_text(mesh_rows_of(source, curve.meshes, pixels), mesh_columns);
  for (const std::string& remark : remarks_on(source, curve.bones)) text += remark + "\n";
  return text;
}

std::string curve_as_json(const CharacterSource& source, const LodCurve& curve, int pixels) {
  const Json all = {{"character", source.name},
                    {"height_metres", source.character->bounds.height},
                    {"pixels_tall", pixels},
                    {"levels", rows_of(source, curve.bones, pixels)},
                    {"mesh_levels", mesh_rows_of(source, curve.meshes, pixels)},
                    {"remarks", remarks_on(source, curve.bones)}};
  return all.dump(2) + "\n";
}

std::string curve_as_svg(const CharacterSource& source, const LodCurve& curve, int pixels) {
  const std::vector<LodLevel>& levels = curve.bones;
  PlotLine time, error;
  time.name = "time, % of all bones";
  error.name = "error, tenths of a pixel";
  for (std::size_t i = levels.size(); i-- > 0;) {
    for (PlotLine* line : {&time, &error}) line->x.push_back(levels[i].bones);
    time.y.push_back(100 * levels[i].nanoseconds / levels.front().nanoseconds);
    error.y.push_back(10 * pixels_of(source, levels[i], pixels));
  }
  return lines_as_svg(source.name + ": what a bone level saves and shows, " + std::to_string(pixels) + " pixels tall",
                      "bones kept", "", {time, error});
}

}  // namespace throng::app
