#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/anim/asset/model.h"

namespace throng::app {

/// Names the piece that is drawn for a part below another part with a tag.
struct PieceBelow {
  std::string tag;
  std::uint16_t piece = 0;
};

/// Describes a part (anim::ModelPart) as far as rules need it.
struct WardrobePart {
  std::string name, slot;
  std::string body;  ///< empty: it fits every body
  std::vector<std::string> covers, keeps_out, tags;
  std::uint16_t piece = 0;        ///< of the character's mesh
  std::vector<PieceBelow> below;  ///< its pieces below other parts

  bool has_tag(std::string_view tag) const;
  bool fits(std::string_view whose) const { return body.empty() || body == whose; }
};

/// Returns the piece that is drawn of `part`, one of the parts that a person wears.
std::uint16_t drawn_piece(const WardrobePart& part, std::span<const WardrobePart* const> worn);

/// Knows all parts of a character. A part is at most once in a list, in the order of the file. A part "NAME/below_TAG"
/// does not count: it is the piece of the part NAME of the same body below a part with the tag.
class Wardrobe {
 public:
  Wardrobe() = default;
  explicit Wardrobe(std::span<const anim::ModelPart> parts);

  bool empty() const { return parts_.empty(); }
  std::span<const WardrobePart> parts() const { return parts_; }
  /// Returns the part of that name that fits a body; null if there is none.
  const WardrobePart* find(std::string_view body, std::string_view name) const;
  /// Returns whether any body has a part of that name.
  bool knows(std::string_view name) const;
  /// Returns the names of all parts, each once.
  std::vector<std::string> names() const;
  /// Returns the bodies, in the order of the file; one body without a name where no part names any.
  std::vector<std::string> bodies() const;

 private:
  bool add_below(const WardrobePart& part);

  std::vector<WardrobePart> parts_;
};

}  // namespace throng::app
