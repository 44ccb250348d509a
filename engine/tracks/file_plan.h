#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "engine/base/result.h"
#include "engine/tracks/ground_plan.h"

namespace throng {

/// A plan in the units and axes of its file: x to the east, y to the north.
using FilePlan = Plan<glm::dvec2>;
using FileRing = FilePlan::Ring;
using FileArea = FilePlan::Area;
using FileLine = FilePlan::Line;

/// Reads Well-Known Text: points are left out, lines become walls, polygons floors, and polygons within another one
/// obstacles. Several geometries may follow each other. The error is the end of a sentence, "line 3: ...; ...".
Result<FilePlan> parse_wkt(std::string_view text);

/// Reads a .floor of crowd:it: walls that are closed become obstacles, and the others walls. A file with one closed
/// wall alone means the floor within it. The error is the end of a sentence, "line 3: ...; ...".
Result<FilePlan> parse_floor(std::string_view text);

/// Reads walls and floors: WKT, a scenario of Vadere, a .floor of crowd:it, or a database of JuPedSim. Errors begin
/// with the file's name.
Result<FilePlan> read_file_plan(const std::string& file);

/// Returns the file of walls beside a file of trajectories and with its name: a .wkt, or a .floor of crowd:it.
std::optional<std::string> plan_beside(const std::string& file);

/// Returns the plan about the file's place `origin`, which is in metres.
GroundPlan placed_plan(const FilePlan& plan, double metres_a_unit, const glm::dvec2& origin);

/// Reads a file of walls that is in metres, about `origin`.
Result<GroundPlan> read_ground_plan(const std::string& file, const glm::dvec2& origin);

}  // namespace throng
