#include "engine/anim/import/json_document.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "engine/anim/import/refusal.h"

namespace throng::import {

namespace {

using nlohmann::json;

/// Brackets outside of strings; not a parser, so that it needs no stack.
void check_depth(std::string_view text) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
      continue;
    }
    if (c == '"') in_string = true;
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    if (depth > max_json_depth) {
      throw Refusal("its JSON is nested deeper than " + std::to_string(max_json_depth) + " levels; remove its extras");
    }
  }
}

/// Extensions whose content import reads.
constexpr std::array read_extensions{"EXT_meshopt_compression", "KHR_texture_transform"};

void keep_read_extensions(json& object) {
  const auto extensions = object.find("extensions");
  if (extensions == object.end()) return;
  if (!extensions->is_object()) throw Refusal("an \"extensions\" in its JSON is not an object; export the file again");
  json kept = json::object();
  for (const char* name : read_extensions) {
    if (const auto extension = extensions->find(name); extension != extensions->end()) {
      kept[name] = std::move(*extension);
    }
  }
  *extensions = std::move(kept);
}

/// Extras may be anything, and go. The data keys among those of an animation become a property of the animation, so
/// that they are checked as all others are.
void keep_data_keys(json& document) {
  const auto animations = document.find("animations");
  if (animations == document.end() || !animations->is_array()) return;
  for (json& animation : *animations) {
    if (!animation.is_object()) continue;
    animation.erase(data_keys_property);
    const auto extras = animation.find("extras");
    if (extras == animation.end() || !extras->is_object() || !extras->contains(data_keys_property)) continue;
    json keys = std::move((*extras)[data_keys_property]);
    animation[data_keys_property] = std::move(keys);
  }
}

void simplify(json& value) {
  constexpr double largest_exact = 9007199254740992.0;  // 2^53
  if (value.is_number_float()) {
    const double number = value.get<double>();
    if (number == std::trunc(number) && std::abs(number) <= largest_exact) value = static_cast<std::int64_t>(number);
    return;
  }
  if (value.is_object()) {
    value.erase("extras");
    keep_read_extensions(value);
  }
  if (value.is_structured()) {
    for (json& element : value) simplify(element);
  }
}

}  // namespace

nlohmann::json parse_json(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  while (!text.empty() && text.back() == '\0') text.remove_suffix(1);
  check_depth(text);
  json document = json::parse(text.begin(), text.end(), nullptr, false);
  if (document.is_discarded()) throw Refusal("it is neither GLB nor valid JSON; export the file again as glTF 2.0");
  if (!document.is_object()) throw Refusal("its JSON is not an object; export the file again as glTF 2.0");
  keep_data_keys(document);
  simplify(document);
  return document;
}

}  // namespace throng::import
