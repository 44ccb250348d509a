#include "app/settings/option_values.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <system_error>

#include "app/settings/quality.h"
#include "app/settings/times_of_day.h"
#include "engine/anim/kernel/choose_kernels.h"

namespace throng::app {
namespace {

/// All parts between commas as finite numbers, or nothing.
std::optional<std::vector<double>> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& part : parts_between_commas(text)) {
    const auto number = finite_number_in(part);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

bool can_be_a_camera(const std::vector<double>& numbers) {
  constexpr double most = farthest_camera;  // degrees too: a float has no whole ones far beyond
  if (numbers.size() != 5 && numbers.size() != 6) return false;
  if (std::ranges::any_of(numbers, [](double number) { return std::abs(number) > most; })) return false;
  const bool field_of_view_fits = numbers.size() == 5 || (numbers[5] >= 1 && numbers[5] <= 170);
  return std::abs(numbers[4]) <= 90 && field_of_view_fits;
}

CameraPose camera_from(const std::vector<double>& numbers) {
  const auto at = [&](std::size_t i) { return static_cast<float>(numbers[i]); };
  CameraPose place{.x = at(0), .y = at(1), .z = at(2), .yaw = at(3), .pitch = at(4)};
  if (numbers.size() == 6) place.field_of_view = at(5);
  return place;
}

}  // namespace

std::optional<double> finite_number_in(const std::string& text) {
  constexpr double most = std::numeric_limits<double>::max();
  double number = 0;
  return read_number(text, -most, most, number) ? std::nullopt : std::optional(number);
}

ValueReader whole_number(int& target, int least, int most) {
  return [&target, least, most](const std::string& text) -> Complaint {
    const Complaint complaint = read_number(text, least, most, target);
    const bool endless = most == std::numeric_limits<int>::max();
    return complaint && endless ? Complaint("must be a whole number, " + std::to_string(least) + " or more")
                                : complaint;
  };
}

std::vector<std::string> parts_between_commas(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find(',', from), text.size());
    parts.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return parts;
}

ValueReader real_number(std::optional<double>& target, double least, double most) {
  return [&target, least, most](const std::string& text) { return read_number(text, least, most, target.emplace()); };
}

ValueReader frame_rate(std::optional<double>& target, double least, double most) {
  return [&target, least, most](const std::string& text) -> Complaint {
    constexpr int most_part = std::numeric_limits<int>::max();
    const std::size_t slash = std::min(text.find('/'), text.size());
    int frames = 0, seconds = 0;
    const bool is_quotient = !read_number(text.substr(0, slash), 1, most_part, frames) && slash < text.size() &&
                             !read_number(text.substr(slash + 1), 1, most_part, seconds);
    const std::string number = is_quotient ? shortest_text(static_cast<double>(frames) / seconds) : text;
    Complaint complaint = read_number(number, least, most, target.emplace());
    if (complaint) complaint->append(", or two whole ones with / between them, such as 30000/1001");
    return complaint;
  };
}

ValueReader number_between(float& target, float least, float most) {
  return [&target, least, most](const std::string& text) {
    return read_number(text, static_cast<double>(least), static_cast<double>(most), target);
  };
}

ValueReader memory_size(std::uint64_t& target) {
  return [&target](const std::string& text) -> Complaint {
    constexpr std::array<std::pair<std::string_view, double>, 8> units{{{"", 1.0},
                                                                        {"B", 1.0},
                                                                        {"KB", 1e3},
                                                                        {"MB", 1e6},
                                                                        {"GB", 1e9},
                                                                        {"KiB", 0x1p10},
                                                                        {"MiB", 0x1p20},
                                                                        {"GiB", 0x1p30}}};
    constexpr double most = 1e15;
    const std::size_t length = std::min(text.find_first_not_of("0123456789."), text.size());
    const auto number = finite_number_in(text.substr(0, length));
    const auto* const unit =
        std::ranges::find(units, std::string_view(text).substr(length), &std::pair<std::string_view, double>::first);
    const double bytes = number && unit != units.end() ? *number * unit->second : 0.0;
    if (!(bytes >= 1.0 && bytes <= most)) return "must be a size, such as 500MB or 2GB";
    target = static_cast<std::uint64_t>(bytes);
    return {};
  };
}

ValueReader scale_above_zero(std::optional<double>& target) { return real_number(target, least_scale, most_scale); }

ValueReader number_above_zero(float& target, std::string unit) {
  return [&target, unit = std::move(unit)](const std::string& text) -> Complaint {
    const auto number = finite_number_in(text);
    constexpr double least = 1e-3, most = 1e6;
    if (!number || *number < least || *number > most) return "must be a number of " + unit + " above 0";
    target = static_cast<float>(*number);
    return {};
  };
}

ValueReader times_list(std::vector<double>& target) {
  return [&target](const std::string& text) -> Complaint {
    auto times = numbers_in(text);
    const auto negative = [](double time) { return time < 0; };
    if (!times || std::any_of(times->begin(), times->end(), negative)) {
      return "must be seconds, 0 or more, with commas between them";
    }
    target = std::move(*times);
    return {};
  };
}

ValueReader role_choices(std::vector<RoleChoice>& target) {
  return [&target](const std::string& text) -> Complaint {
    std::vector<RoleChoice> choices;
    for (const std::string& choice : parts_between_commas(text)) {
      const std::size_t equals = choice.find('=');
      if (equals == std::string::npos || equals + 1 == choice.size()) {
        return "must be ROLE=NAME, with commas between several; roles are " + known_roles();
      }
      const std::string name = choice.substr(0, equals);
      const auto role = role_named(name);
      if (!role) return "there is no role " + name + "; roles are " + known_roles();
      if (std::ranges::find(choices, *role, &RoleChoice::role) != choices.end()) return name + " is given twice";
      choices.push_back({*role, choice.substr(equals + 1)});
    }
    target = std::move(choices);
    return {};
  };
}

ValueReader image_size(int& width, int& height) {
  return [&width, &height](const std::string& text) -> Complaint {
    constexpr int most = most_picture_pixels;
    const std::size_t cross = std::min(text.find('x'), text.size());
    int wide = 0, high = 0;
    if (read_number(text.substr(0, cross), 1, most, wide) ||
        read_number(text.substr(std::min(cross + 1, text.size())), 1, most, high)) {
      return "must be WIDTHxHEIGHT in pixels, each 1 to " + std::to_string(most);
    }
    width = wide;
    height = high;
    return {};
  };
}

ValueReader camera(DemoOptions& options) {
  return [&options](const std::string& text) -> Complaint {
    if (text.find(',') == std::string::npos || text.starts_with("follow:")) {
      options.camera.reset();
      return any_text(options.camera_name)(text);
    }
    options.camera_name.clear();
    options.camera = camera_pose_in(text);
    if (!options.camera) {
      return "must be a camera's name or x,y,z,yaw,pitch[,fov]: metres, degrees, none beyond a million, pitch -90 to "
             "90, fov 1 to 170";
    }
    return {};
  };
}

ValueReader camera_path(DemoOptions& options) {
  return [&options](const std::string& text) -> Complaint {
    options.camera_path_file = text.ends_with(".csv") ? text : std::string();
    if (!options.camera_path_file.empty()) return {};
    const auto* const named = std::ranges::find(camera_path_words, text);
    if (named == camera_path_words.end()) return "must be none, orbit, pan, or a file that ends in .csv";
    options.camera_path = static_cast<CameraPath>(named - camera_path_words.begin());
    return {};
  };
}

std::optional<CameraPose> camera_pose_in(const std::string& text) {
  const auto numbers = numbers_in(text);
  return numbers && can_be_a_camera(*numbers) ? std::optional(camera_from(*numbers)) : std::nullopt;
}

ValueReader ends_of_line(std::optional<std::pair<glm::dvec2, glm::dvec2>>& target) {
  return [&target](const std::string& text) -> Complaint {
    const auto numbers = numbers_in(text).value_or(std::vector<double>());
    const bool is_line = numbers.size() == 4 && (numbers[0] != numbers[2] || numbers[1] != numbers[3]);
    if (!is_line) return "must be X1,Y1,X2,Y2: two points in metres of the file";
    target.emplace(glm::dvec2(numbers[0], numbers[1]), glm::dvec2(numbers[2], numbers[3]));
    return {};
  };
}

std::string names_of_times() {
  std::vector<std::string> names;
  names.reserve(times_of_day.size());
  for (const TimeOfDay& time : times_of_day) names.emplace_back(time.name);
  return joined(names, ", ", " or ");
}

ValueReader quality(DemoOptions& options) {
  return [&options](const std::string& text) -> Complaint {
    if (!take_quality(text, options.tuning)) return "must be low, medium, high or auto";
    std::vector<std::string>& given = options.values_given.keys;
    given.emplace_back("holds_rate");
    if (!options.tuning.holds_rate) given.insert(given.end(), picture_cost_keys.begin(), picture_cost_keys.end());
    return {};
  };
}

ValueReader sun(render::SceneLight& light) {
  return [&light](const std::string& text) -> Complaint {
    const auto* const named = std::ranges::find(times_of_day, text, &TimeOfDay::name);
    if (named != times_of_day.end()) {
      light = named->light;
      return {};
    }
    const auto numbers = numbers_in(text);
    if (!numbers || numbers->size() != 2 || std::abs((*numbers)[0]) > 90 || std::abs((*numbers)[1]) > 360) {
      return "must be " + names_of_times() + ", or ELEVATION,AZIMUTH: degrees, -90 to 90 and -360 to 360";
    }
    const double azimuth = (*numbers)[1];
    light.sun_elevation = static_cast<float>((*numbers)[0]);
    light.sun_azimuth = static_cast<float>(azimuth < 0 ? azimuth + 360 : azimuth);
    return {};
  };
}

ValueReader simd_target(const anim::Kernels*& target) {
  return [&target](const std::string& text) -> Complaint {
    const anim::Kernels* const kernels = anim::find_kernels(text);
    if (kernels == nullptr) return "this processor and build have " + joined(anim::runnable_targets(), ", ", " and ");
    target = kernels;
    return {};
  };
}

ValueReader any_text(std::string& target) {
  return [&target](const std::string& text) -> Complaint {
    if (text.empty()) return "must not be empty";
    target = text;
    return {};
  };
}

ValueReader existing_folder(std::string& target) {
  return [&target](const std::string& text) -> Complaint {
    std::error_code error;
    if (!std::filesystem::is_directory(text, error)) return "must be a folder that is there";
    target = text;
    return {};
  };
}

ValueReader file_name(std::string& target) {
  return [&target](const std::string& text) -> Complaint {
    if (text == "-") return "must be a file; it is not written to standard output";
    return any_text(target)(text);
  };
}

ValueReader file_names(std::vector<std::string>& target) {
  return [&target](const std::string& text) -> Complaint {
    std::vector<std::string> files = parts_between_commas(text);
    if (std::ranges::count(files, std::string()) > 0) return "must be files, with commas between several";
    target = std::move(files);
    return {};
  };
}

ValueReader file_that_ends_in(std::string ending, std::string& target) {
  return [ending = std::move(ending), &target](const std::string& text) -> Complaint {
    std::string small = text;
    std::ranges::transform(small, small.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (!small.ends_with(ending)) return "must be a file name that ends in " + ending;
    target = text;
    return {};
  };
}

}  // namespace throng::app
