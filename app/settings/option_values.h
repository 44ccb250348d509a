#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/settings/settings.h"

namespace throng::app {

/// What is wrong with the text of an option, as the end of a sentence: "must be 0 or 4". Nothing: it was taken.
using Complaint = std::optional<std::string>;

/// Reads the text of an option into the variable that the reader was made for, which must outlive it.
using ValueReader = std::function<Complaint(const std::string& text)>;

ValueReader whole_number(int& target, int least, int most);
/// N[,N...]: each least to most.
ValueReader number_list(std::vector<int>& target, int least, int most);
/// Any number, least to most.
ValueReader number_between(float& target, float least, float most);
ValueReader seed_number(std::uint32_t& target);
ValueReader seconds_above_zero(std::optional<double>& target);
/// Above 0; `unit` is named where it is refused: "pixels".
ValueReader number_above_zero(float& target, std::string unit);
ValueReader times_list(std::vector<double>& target);  ///< T[,T...] in seconds, none negative
ValueReader image_size(int& width, int& height);      ///< WxH in pixels, each 1 to 16,384
ValueReader auto_or_kibibytes(int& target);           ///< auto is 0
ValueReader mesh_lod(int& target);                    ///< on is -1, off is 0, else 0 to 3
ValueReader camera(DemoOptions& options);             ///< a name, or x,y,z,yaw,pitch[,fov]
ValueReader any_text(std::string& target);
ValueReader existing_folder(std::string& target);
ValueReader file_name(std::string& target);  ///< anything but `-`, which elsewhere means standard output
ValueReader png_file(std::string& target);
ValueReader svg_file(std::string& target);
ValueReader role_choices(std::vector<RoleChoice>& target);  ///< ROLE=NAME[,ROLE=NAME...], each role once

/// "must be a, b or c".
std::string must_be_one_of(const std::vector<std::string>& names);

/// One of a few words; `Target` is the value's type or an optional of it.
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
    return must_be_one_of(names);
  };
}

/// The parts of a text between commas.
std::vector<std::string> parts_between_commas(const std::string& text);

/// One of a few words, or several with commas between them.
template <typename Value>
ValueReader choice_list(std::vector<Value>& target, std::vector<std::pair<std::string, Value>> choices) {
  return [&target, choices = std::move(choices)](const std::string& text) -> Complaint {
    std::vector<Value> values;
    for (const std::string& part : parts_between_commas(text)) {
      Value value{};
      if (const Complaint complaint = choice<Value>(value, choices)(part)) {
        return *complaint + ", with commas between several";
      }
      values.push_back(value);
    }
    target = std::move(values);
    return {};
  };
}

inline ValueReader on_or_off(bool& target) { return choice<bool>(target, {{"on", true}, {"off", false}}); }

}  // namespace throng::app
