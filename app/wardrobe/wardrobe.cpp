#include "app/wardrobe/wardrobe.h"

#include <algorithm>

namespace throng::app {

bool WardrobePart::has_tag(std::string_view tag) const { return std::ranges::find(tags, tag) != tags.end(); }

Wardrobe::Wardrobe(std::span<const anim::ModelPart> parts) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const anim::ModelPart& part = parts[i];
    parts_.push_back({.name = part.name,
                      .slot = part.slot,
                      .body = part.body,
                      .covers = part.covers,
                      .keeps_out = part.keeps_out,
                      .tags = part.tags,
                      .piece = static_cast<std::uint16_t>(i + 1)});  // piece 0 is the mesh without parts
  }
}

const WardrobePart* Wardrobe::find(std::string_view body, std::string_view name) const {
  const auto found =
      std::ranges::find_if(parts_, [&](const WardrobePart& part) { return part.name == name && part.fits(body); });
  return found == parts_.end() ? nullptr : &*found;
}

bool Wardrobe::knows(std::string_view name) const {
  return std::ranges::find(parts_, name, &WardrobePart::name) != parts_.end();
}

std::vector<std::string> Wardrobe::names() const {
  std::vector<std::string> names;
  for (const WardrobePart& part : parts_) {
    if (std::ranges::find(names, part.name) == names.end()) names.push_back(part.name);
  }
  return names;
}

std::vector<std::string> Wardrobe::bodies() const {
  std::vector<std::string> bodies;
  for (const WardrobePart& part : parts_) {
    if (!part.body.empty() && std::ranges::find(bodies, part.body) == bodies.end()) bodies.push_back(part.body);
  }
  if (bodies.empty()) bodies.emplace_back();
  return bodies;
}

}  // namespace throng::app
