#include "engine/tracks/file_plan.h"

#include <filesystem>
#include <span>
#include <utility>

#include "engine/base/files/input_file.h"
#include "engine/tracks/sqlite_file.h"
#include "engine/tracks/text/head_lines.h"
#include "engine/tracks/text/xml_text.h"
#include "engine/tracks/text_format.h"
#include "engine/tracks/vadere_plan.h"

namespace throng {
namespace {

GroundRing placed_ring(const FileRing& ring, double unit, const glm::dvec2& origin) {
  GroundRing placed;
  placed.reserve(ring.size());
  for (const glm::dvec2& point : ring) {
    placed.emplace_back(static_cast<float>(point.x * unit - origin.x), static_cast<float>(origin.y - point.y * unit));
  }
  return placed;
}

GroundArea placed_area(const FileArea& area, double unit, const glm::dvec2& origin) {
  GroundArea placed{placed_ring(area.outline, unit, origin), {}};
  for (const FileRing& hole : area.holes) placed.holes.push_back(placed_ring(hole, unit, origin));
  return placed;
}

/// Reads walls in any text format. The error is the end of a sentence.
Result<FilePlan> plan_of_text(std::string_view text) {
  if (std::string why = why_no_text(text, "name walls: WKT, .scenario or .floor"); !why.empty()) return Error{why};
  text.remove_prefix(byte_order_mark(text));
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return Error{"it is empty; name a file with walls"};
  if (is_xml(text)) return parse_floor(text);
  if (text[first] != '{') return parse_wkt(text);
  const auto json = parse_json(text);
  if (!json) return Error{"its text " + json.error().message + "; name a .scenario of Vadere, or walls as WKT"};
  auto scenario = vadere_scenario(*json);
  return scenario ? Result<FilePlan>(std::move(scenario->plan)) : scenario.error();
}

}  // namespace

GroundPlan placed_plan(const FilePlan& plan, double metres_a_unit, const glm::dvec2& origin) {
  GroundPlan placed;
  placed.unknown_shapes = plan.unknown_shapes;
  for (const FileArea& area : plan.floors) placed.floors.push_back(placed_area(area, metres_a_unit, origin));
  for (const FileRing& ring : plan.obstacles) placed.obstacles.push_back(placed_ring(ring, metres_a_unit, origin));
  for (const FileLine& line : plan.walls) {
    placed.walls.push_back({placed_ring(line.points, metres_a_unit, origin), line.name});
  }
  for (const FileArea& area : plan.exits) placed.exits.push_back(placed_area(area, metres_a_unit, origin));
  for (const FileLine& line : plan.measurement_lines) {
    placed.measurement_lines.push_back({placed_ring(line.points, metres_a_unit, origin), line.name});
  }
  return placed;
}

Result<FilePlan> read_file_plan(const std::string& file) {
  constexpr std::size_t most_bytes = std::size_t{256} << 20U;
  const auto opened = InputFile::open(file, "a file of walls");
  if (!opened) return Error{file + ": " + opened.error().message};
  std::string head(16, '\0');
  InputFile input = *opened;
  const auto read = input.read(std::as_writable_bytes(std::span(head)));
  if (read && is_sqlite(head)) return read_sqlite_plan(file);
  const auto text = read_text(file, "a file of walls", most_bytes);
  if (!text) return Error{file + ": " + text.error().message};
  auto plan = plan_of_text(*text);
  return plan ? std::move(plan) : Error{file + ": " + plan.error().message};
}

std::optional<std::string> plan_beside(const std::string& file) {
  std::error_code error;
  for (const char* const extension : {".wkt", ".floor"}) {
    const auto beside = std::filesystem::path(file).replace_extension(extension);
    if (beside != file && std::filesystem::is_regular_file(beside, error)) return beside.string();
  }
  return {};
}

Result<GroundPlan> read_ground_plan(const std::string& file, const glm::dvec2& origin) {
  const auto plan = read_file_plan(file);
  if (!plan) return plan.error();
  return placed_plan(*plan, 1.0, origin);
}

}  // namespace throng
