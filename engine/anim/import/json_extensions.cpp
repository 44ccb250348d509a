#include "engine/anim/import/json_extensions.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <set>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "engine/anim/import/bytes/refusal.h"
#include "engine/anim/import/json_document.h"

namespace throng::import {

namespace {

using nlohmann::json;

/// Beginnings of the names of extensions that change neither shape nor motion: lights, sounds, physics, metadata, other
/// forms of a picture, and what avatars do beside their clips.
constexpr std::array<std::string_view, 18> harmless{"KHR_lights_",   "EXT_lights_",       "KHR_audio",
                                                    "MSFT_audio_",   "KHR_physics_",      "KHR_implicit_",
                                                    "OMI_",          "KHR_xmp",           "EXT_texture_",
                                                    "MSFT_texture_", "KHR_texture_",      "MSFT_packing_",
                                                    "KHR_node_",     "KHR_interactivity", "KHR_animation_pointer",
                                                    "VRMC_",         "MSFT_lod",          "EXT_structural_metadata"};

/// Import follows these, or names their parts where it leaves them out.
bool is_followed(std::string_view name) {
  return name == "KHR_mesh_quantization" || std::ranges::count(read_extensions, name) > 0;
}

bool is_harmless(std::string_view name) {
  if (name.find("_materials_") != std::string_view::npos) return true;
  return std::ranges::any_of(harmless, [&](std::string_view begin) { return name.starts_with(begin); });
}

bool uses_unknown_extension(json& document) {
  const auto is_unknown = [](const json& name) {
    return name.is_string() && !is_followed(name.get_ref<const std::string&>());
  };
  return std::ranges::any_of(elements(document, "extensionsUsed"), is_unknown);
}

/// Leaves values out of the animations and materials of a document.
class ValueSweep {
 public:
  ValueSweep(json& document, std::vector<std::string>& repairs)
      : document_(document), repairs_(repairs), extended_(uses_unknown_extension(document)) {}

  void run() {
    std::size_t index = 0;
    for (json& animation : elements(document_, "animations")) sweep_animation(animation, index++);
    index = 0;
    for (json& material : elements(document_, "materials")) sweep_material(material, index++);
  }

 private:
  using Values = std::initializer_list<std::string_view>;

  /// Returns the text of `key` if it is none of `known` and an extension may explain it; else null.
  const std::string* unknown_value(json& object, const char* key, Values known) const {
    const json* const value = find_property(object, key);
    if (value == nullptr || !value->is_string()) return nullptr;
    const std::string& text = value->get_ref<const std::string&>();
    const bool is_known = std::ranges::find(known, text) != known.end();
    return !is_known && (extended_ || object.contains("extensions")) ? &text : nullptr;
  }

  void sweep_animation(json& animation, std::size_t index) {
    const std::string name = json_label("animation", index, animation);
    const std::set<std::size_t> samplers = sweep_samplers(animation);
    std::size_t channel_index = 0;
    for (json& channel : elements(animation, "channels")) {
      const std::string where = name + ", channel " + std::to_string(channel_index++);
      json* const target = find_property(channel, "target");
      if (target == nullptr) continue;
      if (const std::string* path = unknown_value(*target, "path", {"translation", "rotation", "scale", "weights"})) {
        leave_out(*target, where + ": animates \"" + *path + "\", which an extension adds, left out");
      } else if (const json* const sampler = find_property(channel, "sampler");
                 sampler != nullptr && sampler->is_number_unsigned() &&
                 samplers.contains(sampler->get<std::size_t>())) {
        leave_out(*target, where + ": an extension adds its interpolation, left out");
      }
    }
  }

  /// Returns the samplers of unknown interpolation, which then interpolate as any other.
  std::set<std::size_t> sweep_samplers(json& animation) {
    std::set<std::size_t> unknown;
    std::size_t index = 0;
    for (json& sampler : elements(animation, "samplers")) {
      if (unknown_value(sampler, "interpolation", {"LINEAR", "STEP", "CUBICSPLINE"}) != nullptr) {
        sampler.erase("interpolation");
        unknown.insert(index);
      }
      ++index;
    }
    return unknown;
  }

  /// A channel stays, so that the others keep their numbers. Without a node it animates nothing (glTF 2.0, 3.11).
  void leave_out(json& target, std::string sentence) {
    repairs_.push_back(std::move(sentence));
    target = {{"path", "translation"}};
  }

  void sweep_material(json& material, std::size_t index) {
    const std::string* const mode = unknown_value(material, "alphaMode", {"OPAQUE", "MASK", "BLEND"});
    if (mode == nullptr) return;
    repairs_.push_back(json_label("material", index, material) + ": an extension adds its alpha mode \"" + *mode +
                       "\", drawn as opaque");
    material.erase("alphaMode");
  }

  json& document_;
  std::vector<std::string>& repairs_;
  bool extended_;
};

}  // namespace

void check_required_extensions(const json& document, std::vector<std::string>& repairs) {
  const auto extensions = document.find("extensionsRequired");
  if (extensions == document.end()) return;
  for (const json& extension : *extensions) {
    const auto name = extension.get<std::string>();
    if (is_followed(name)) continue;
    if (!is_harmless(name)) {
      throw Refusal("it requires the extension " + name + ", which is not supported; export without it");
    }
    repairs.push_back("it requires the extension " + name + ", which is not followed: taken without it");
  }
}

void leave_out_unknown_values(json& document, std::vector<std::string>& repairs) {
  ValueSweep(document, repairs).run();
}

}  // namespace throng::import
