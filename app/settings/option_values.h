#pragma once

#include <charconv>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "app/character/cast_entry.h"
#include "app/settings/settings.h"
#include "engine/base/text/joined.h"

namespace throng::app {

/// The fault in the text of an option, as the end of a sentence: "must be 0 or 4". Nothing: the text was taken.
using Complaint = std::optional<std::string>;

/// Reads the text of an option into a variable, which must outlive the reader.
using ValueReader = std::function<Complaint(const std::string& text)>;

/// Returns the shortest text that reads back as the same number to the bit.
template <typename Number>
std::string shortest_text(Number number) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof(text), number).ptr};
}

template <typename Number>
std::string range_text(double least, double most) {
  return shortest_text(static_cast<Number>(least)) + " to " + shortest_text(static_cast<Number>(most));
}

template <typename Number>
Complaint read_number(const std::string& text, double least, double most, Number& target) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  const bool fits = error == std::errc{} && stop == end && number >= static_cast<Number>(least) &&
                    number <= static_cast<Number>(most);
  if (!fits)
    return (std::is_integral_v<Number> ? "must be a whole number, " : "must be a number, ") +
           range_text<Number>(least, most);
  target = number;
  return {};
}

ValueReader whole_number(int& target, int least, int most);
/// Reads any number from `least` to `most`.
ValueReader number_between(float& target, float least, float most);
/// Reads any number from `least` to `most`.
ValueReader real_number(std::optional<double>& target, double least, double most);
/// Reads frames a second from `least` to `most`: a number, or a quotient of two whole ones as 30000/1001.
ValueReader frame_rate(std::optional<double>& target, double least, double most);
/// Reads a number of bytes with or without a unit: "500MB", "1.5GB", "2GiB".
ValueReader memory_size(std::uint64_t& target);
/// Reads a scale from least_scale to most_scale, metres a unit of a model's file.
inline constexpr double least_scale = 1e-6, most_scale = 1e6;
ValueReader scale_above_zero(std::optional<double>& target);
/// Reads a number above 0. A complaint names the `unit`: "pixels".
ValueReader number_above_zero(float& target, std::string unit);
ValueReader times_list(std::vector<double>& target);  ///< T[,T...] in seconds, none negative
ValueReader image_size(int& width, int& height);      ///< WxH in pixels, each 1 to most_picture_pixels
ValueReader camera(DemoOptions& options);             ///< a name, follow:ID, or a text of camera_pose_in()
ValueReader camera_path(DemoOptions& options);        ///< none, orbit, pan, or a file that ends in .csv
/// Returns the finite number in a text; nothing where it is none.
std::optional<double> finite_number_in(const std::string& text);
/// Returns a camera of x,y,z,yaw,pitch[,fov], in metres and degrees; nothing where the text is none.
std::optional<CameraPose> camera_pose_in(const std::string& text);
/// Reads X1,Y1,X2,Y2, the two ends of a line in metres.
ValueReader ends_of_line(std::optional<std::pair<glm::dvec2, glm::dvec2>>& target);
ValueReader quality(DemoOptions& options);   ///< one of `qualities`, or auto
ValueReader sun(render::SceneLight& light);  ///< a time of day, or elevation,azimuth in degrees
/// Reads the name of a SIMD target that this build has and this machine runs.
ValueReader simd_target(const anim::Kernels*& target);
ValueReader any_text(std::string& target);
ValueReader existing_folder(std::string& target);
ValueReader file_name(std::string& target);                ///< anything but `-`, which elsewhere means standard output
ValueReader file_names(std::vector<std::string>& target);  ///< FILE[,FILE...]
ValueReader file_that_ends_in(std::string ending, std::string& target);
ValueReader role_choices(std::vector<RoleChoice>& target);  ///< ROLE=NAME[,ROLE=NAME...], each role once

/// Reads ENTRY[*SHARE][,ENTRY[*SHARE]...]; an entry is a file, FILE#SKIN, or a folder. A file whose own name ends like
/// a share goes first.
ValueReader cast_entries(std::vector<CastEntry>& target);

/// Reads entries of cast_entries(), or the name of a file of rules, which ends in .json.
ValueReader cast_or_rules(std::vector<CastEntry>& target, std::string& rules);

/// These read VALUE, for all models, or NAME=VALUE, for the model of that name, with commas between several. A name is
/// a file's, with or without its ending, or a character's. A value for one model wins over the value for all.
ValueReader model_scales(anim::PlacementChoice& all, std::vector<ModelPlacement>& some);
ValueReader model_up_axes(anim::PlacementChoice& all, std::vector<ModelPlacement>& some);
ValueReader model_grounds(anim::PlacementChoice& all, std::vector<ModelPlacement>& some);

/// These two read a value for all models.
ValueReader up_axis(anim::UpAxis& target);
ValueReader ground_rule(anim::GroundRule& target);

/// Reads one of a few words. `Target` is the value's type or an optional of it.
template <typename Value, typename Target>
ValueReader choice(Target& target, std::vector<std::pair<std::string, Value>> choices) {
  return [&target, choices = std::move(choices)](const std::string& text) -> Complaint {
    std::vector<std::string> names;
    for (const auto& [name, value] : choices) {
      if (name == text) {
        target = value;
        return {};
      }
      names.push_back(name);
    }
    return "must be " + joined(names, ", ", " or ");
  };
}

/// Returns the parts of a text between commas.
std::vector<std::string> parts_between_commas(const std::string& text);

inline ValueReader on_or_off(bool& target) { return choice<bool>(target, {{"on", true}, {"off", false}}); }

}  // namespace throng::app
