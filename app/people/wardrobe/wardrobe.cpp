#include "app/people/wardrobe/wardrobe.h"

#include <algorithm>
#include <utility>

namespace throng::app {

bool WardrobePart::has_tag(std::string_view tag) const { return std::ranges::find(tags, tag) != tags.end(); }

std::uint16_t drawn_piece(const WardrobePart& part, std::span<const WardrobePart* const> worn) {
  for (const PieceBelow& below : part.below) {
    const auto lies_over = [&](const WardrobePart* other) { return other != &part && other->has_tag(below.tag); };
    if (std::ranges::any_of(worn, lies_over)) return below.piece;
  }
  return part.piece;
}

Wardrobe::Wardrobe(std::span<const anim::ModelPart> parts) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const anim::ModelPart& described = parts[i];
    WardrobePart part{.name = described.name,
                      .slot = described.slot,
                      .body = described.body,
                      .covers = described.covers,
                      .keeps_out = described.keeps_out,
                      .tags = described.tags,
                      .piece = static_cast<std::uint16_t>(i + 1),  // piece 0 is the mesh without parts
                      .below = {}};
    if (!add_below(part)) parts_.push_back(std::move(part));
  }
}

bool Wardrobe::add_below(const WardrobePart& part) {
  constexpr std::string_view infix = "/below_";
  const std::size_t end = part.name.rfind(infix);
  if (end == std::string::npos) return false;
  const auto whole = std::ranges::find_if(parts_, [&](const WardrobePart& each) {
    return each.body == part.body && each.name == std::string_view(part.name).substr(0, end);
  });
  if (whole == parts_.end()) return false;
  whole->below.push_back({part.name.substr(end + infix.size()), part.piece});
  return true;
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
