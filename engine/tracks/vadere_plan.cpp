#include "engine/tracks/vadere_plan.h"

#include <cmath>
#include <filesystem>
#include <numbers>
#include <system_error>
#include <utility>

namespace throng {
namespace {

bool take_number(const Json& object, std::string_view key, double& number) {
  const Json& value = object[key];
  if (!value.is_number()) return false;
  number = value.get<double>();
  return std::isfinite(number) && std::abs(number) <= 1e10;
}

FileRing rectangle(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

FileRing circle(const glm::dvec2& center, double radius) {
  constexpr int corners = 32;
  FileRing ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    ring.push_back(center + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

/// Returns the corners of a shape; none if it is of another kind, which the plan counts.
FileRing ring_of(const Json& shape, FilePlan& plan) {
  FileRing ring;
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
  for (const Json& point : shape["points"].elements()) {
    if (!take_number(point, "x", x) || !take_number(point, "y", y)) {
      ring.clear();
      break;
    }
    ring.emplace_back(x, y);
  }
  if (shape.contains("width")) {
    const bool is_whole = take_number(shape, "x", x) && take_number(shape, "y", y) &&
                          take_number(shape, "width", width) && take_number(shape, "height", height);
    if (is_whole) ring = rectangle(x, y, width, height);
  }
  if (shape.contains("radius")) {
    const Json& center = shape["center"];
    const bool is_whole =
        take_number(center, "x", x) && take_number(center, "y", y) && take_number(shape, "radius", width);
    if (is_whole && width > 0.0) ring = circle({x, y}, width);
  }
  if (ring.size() > 2) return ring;
  ++plan.unknown_shapes;
  return {};
}

/// Returns the floor within the border, where there is one.
std::optional<FileRing> border_of(const Json& attributes) {
  const Json& bounds = attributes["bounds"];
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0, wall = 0.0;
  const bool is_whole = take_number(bounds, "x", x) && take_number(bounds, "y", y) &&
                        take_number(bounds, "width", width) && take_number(bounds, "height", height);
  if (!is_whole || !attributes.value("bounded", true)) return {};
  if (!take_number(attributes, "boundingBoxWidth", wall)) wall = 0.0;
  if (width <= 2.0 * wall || height <= 2.0 * wall) return {};
  return rectangle(x + wall, y + wall, width - 2.0 * wall, height - 2.0 * wall);
}

}  // namespace

Result<VadereScenario> vadere_scenario(const Json& json) {
  const Json& scenario = json["scenario"].is_object() ? json["scenario"] : json["vadere"];
  const Json& topography = scenario["topography"].is_object() ? scenario["topography"] : json["topography"];
  if (!topography.is_object()) {
    return Error{"it has no topography; name a .scenario of Vadere, or walls as WKT"};
  }
  VadereScenario result;
  FilePlan& plan = result.plan;
  if (auto border = border_of(topography["attributes"])) plan.floors.push_back({std::move(*border), {}});
  for (const Json& obstacle : topography["obstacles"].elements()) {
    if (FileRing ring = ring_of(obstacle["shape"], plan); !ring.empty()) plan.obstacles.push_back(std::move(ring));
  }
  for (const Json& target : topography["targets"].elements()) {
    if (FileRing ring = ring_of(target["shape"], plan); !ring.empty()) plan.exits.push_back({std::move(ring), {}});
  }
  for (const Json& area : topography["measurementAreas"].elements()) {
    FileRing ring = ring_of(area["shape"], plan);
    if (ring.empty()) continue;
    ring.push_back(ring.front());
    plan.measurement_lines.push_back({std::move(ring), {}});
  }
  double step = 0.0;
  if (take_number(scenario["attributesSimulation"], "simTimeStepLength", step) && step > 0.0) {
    result.seconds_a_step = step;
  }
  return result;
}

std::optional<std::string> scenario_beside(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path same = fs::path(file).replace_extension(".scenario");
  if (fs::is_regular_file(same, error)) return same.string();
  fs::path folder = fs::path(file).parent_path();
  if (folder.empty()) folder = ".";
  std::optional<std::string> only;
  std::size_t seen = 0;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end && seen < 1000;
       entry.increment(error)) {
    ++seen;
    if (entry->path().extension() != ".scenario") continue;
    if (only) return {};
    only = (fs::path(file).parent_path() / entry->path().filename()).string();
  }
  return only;
}

}  // namespace throng
