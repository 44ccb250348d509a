#include "app/show/camera/camera_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string_view>

#include <glm/common.hpp>

#include "app/settings/option_values.h"
#include "app/show/camera/fly_camera.h"
#include "engine/base/files/input_file.h"
#include "engine/base/text/joined.h"
#include "engine/tracks/text/head_lines.h"
#include "engine/tracks/text/table_layout.h"
#include "engine/tracks/text_format.h"

namespace throng::app {
namespace {

constexpr double whole_turn = 2.0 * std::numbers::pi;
constexpr double orbit_seconds = 60.0;
constexpr double pan_seconds = 10.0;
constexpr double pan_radians = std::numbers::pi / 6.0;

render::Camera orbited(render::Camera camera, double angle) {
  const auto cosine = static_cast<float>(std::cos(angle)), sine = static_cast<float>(std::sin(angle));
  const glm::vec3 from = camera.position;
  camera.position = {from.x * cosine + from.z * sine, from.y, from.z * cosine - from.x * sine};
  camera.yaw += static_cast<float>(angle);
  return camera;
}

constexpr std::size_t most_path_bytes = std::size_t{16} << 20U;
using Values = std::array<float, 6>;

Values values_of(const CameraPose& place) {
  return {place.x, place.y, place.z, place.yaw, place.pitch, place.field_of_view};
}

/// Returns how fast the values change at a key: the mean from the key before it to the key after it. The camera sets
/// out from its first key and arrives at its last.
Values slope(const std::vector<CameraKey>& keys, std::size_t key) {
  Values slopes{};
  if (key == 0 || key + 1 == keys.size()) return slopes;
  const Values first = values_of(keys[key - 1].place), last = values_of(keys[key + 1].place);
  const auto seconds = static_cast<float>(keys[key + 1].seconds - keys[key - 1].seconds);
  for (std::size_t i = 0; i < slopes.size(); ++i) slopes[i] = (last[i] - first[i]) / seconds;
  return slopes;
}

Error fault(const std::string& file, std::size_t line, const std::string& what) {
  return Error{file + ": line " + std::to_string(line) + ": " + what};
}

constexpr std::array<std::string_view, 7> all_names{"time", "x", "y", "z", "yaw", "pitch", "fov"};

/// Returns the numbers of a row with commas between them, as options have them, and with points in them.
std::string with_commas(const std::string& line, char separator) {
  std::vector<std::string> fields = fields_of(line, separator);
  if (separator != ',') {
    for (std::string& field : fields) std::ranges::replace(field, ',', '.');
  }
  return joined(fields, ",", ",");
}

}  // namespace

render::Camera along(CameraPath path, const render::Camera& start, double seconds) {
  if (path == CameraPath::orbit) return orbited(start, whole_turn * std::fmod(seconds, orbit_seconds) / orbit_seconds);
  render::Camera camera = start;
  if (path == CameraPath::pan)
    camera.yaw += static_cast<float>(pan_radians * std::sin(whole_turn * seconds / pan_seconds));
  return camera;
}

Result<std::vector<CameraKey>> read_camera_keys(const std::string& file) {
  const auto text = read_text(file, "a camera path", most_path_bytes);
  if (!text) return Error{file + ": " + text.error().message};
  if (const std::string why = why_no_text(*text, "name a table of camera keys"); !why.empty()) {
    return Error{file + ": " + why};
  }
  const HeadLines head = lines_of(*text);
  const char separator = separator_of(head.first);
  std::vector<std::string> names = fields_of(head.first, separator);
  if (names.size() == all_names.size() - 1) names.emplace_back(all_names.back());  // the last may be left out
  if (!std::ranges::equal(names, all_names)) {
    return fault(file, head.first_line, "it is no header of a camera path; begin with time,x,y,z,yaw,pitch,fov");
  }
  std::istringstream lines(text->substr(head.body_byte));
  std::vector<CameraKey> keys;
  std::string line;
  for (std::size_t number = head.body_line; std::getline(lines, line); ++number) {
    const std::string row = with_commas(line, separator);
    if (row.empty() || is_comment(row)) continue;
    const std::size_t comma = row.find(',');
    const auto seconds = finite_number_in(row.substr(0, comma));
    const auto place = comma == std::string::npos ? std::nullopt : camera_pose_in(row.substr(comma + 1));
    if (!seconds || !place)
      return fault(file, number, "it is no key; write seconds and then a place as --camera has it");
    if (!keys.empty() && *seconds <= keys.back().seconds) {
      return fault(file, number, "its time is not after that of the key before; sort the keys by time");
    }
    keys.push_back({*seconds, *place});
    if (keys.size() < 2) continue;
    float& yaw = keys.back().place.yaw;
    yaw -= 360.0F * std::round((yaw - keys[keys.size() - 2].place.yaw) / 360.0F);
  }
  if (keys.empty()) return Error{file + ": it has no key; write a row a key below the header"};
  return keys;
}

render::Camera along(const std::vector<CameraKey>& keys, double seconds) {
  const auto after = std::ranges::upper_bound(keys, seconds, {}, &CameraKey::seconds);
  if (after == keys.begin()) return camera_at(keys.front().place);
  if (after == keys.end()) return camera_at(keys.back().place);
  const auto to = static_cast<std::size_t>(after - keys.begin()), from = to - 1;
  const auto length = static_cast<float>(keys[to].seconds - keys[from].seconds);
  const float t = static_cast<float>(seconds - keys[from].seconds) / length, back = 1.0F - t;
  const Values first = values_of(keys[from].place), last = values_of(keys[to].place);
  const Values leaves = slope(keys, from), arrives = slope(keys, to);
  Values at{};
  for (std::size_t i = 0; i < at.size(); ++i) {
    at[i] = first[i] + glm::smoothstep(0.0F, 1.0F, t) * (last[i] - first[i]) +
            length * t * back * (leaves[i] * back - arrives[i] * t);
  }
  return camera_at({at[0], at[1], at[2], at[3], at[4], std::clamp(at[5], 1.0F, 170.0F)});
}

}  // namespace throng::app
