#pragma once

#include <optional>
#include <string>

#include "engine/anim/asset/placement.h"
#include "engine/anim/survey/model_extent.h"

namespace throng::anim {

/// The axis of a file that points up in the scene. glTF 2.0, 3.4: +Y.
enum class UpAxis : unsigned char { x, y, z, minus_x, minus_y, minus_z };

/// Says which point stands at the agent's place. `guess` is the file's origin, unless the body is far from it or
/// reaches below it.
enum class GroundRule : unsigned char { guess, file, feet };

/// Says how the probable size of a file is changed. `kept` leaves it. `among_people` brings a model that is too
/// small or too large for a place that is made for people to a size that fits there.
enum class SizeRule : unsigned char { kept, among_people };

/// Holds a person's wishes for a model's size and place. The rest is guessed.
struct PlacementChoice {
  std::optional<double> scale = std::nullopt;  ///< metres a unit of the file, above 0
  UpAxis up = UpAxis::y;
  GroundRule ground = GroundRule::guess;

  friend bool operator==(const PlacementChoice&, const PlacementChoice&) = default;
};

/// Holds the placement of a model, and the reasons for it.
struct GuessedPlacement {
  Placement placement;
  double height = 0.0;                  ///< metres; 0 for a model without extent
  bool is_plain = true;                 ///< the file is in metres and stands on its origin, so that nothing was changed
  PlacementChoice choice{};             ///< the person's wishes
  std::optional<ModelExtent> extent{};  ///< in units of the file, turned upright; none for a model without extent
  std::string reasons{};  ///< one sentence for people, plain or not: "1.76 m tall: taken as centimetres, ..."
};

/// These sizes fit among people, in metres: the height of an upright model, the largest side of any other.
inline constexpr double least_among_people = 0.25, tallest_among_people = 3.0, longest_among_people = 4.0;

/// Returns the metres a unit of the file that a model of that size, in units of its file, is taken to have.
double guessed_scale(const ModelExtent& extent, SizeRule rule);

/// Finds the size and place of a model that a person would expect. Sizes that people, animals and houses have in metres
/// are kept (largest side from 4 cm to 40 m); others are taken as centimetres, millimetres or whatever power of ten
/// brings them nearest to a person. A model beside the origin is moved there, and a model that reaches below the
/// ground or floats far above it is put on it. `model` is as imported. By SizeRule::among_people, a model that stands
/// upright and does not fit becomes as tall as a person, and any other takes the nearest size that fits, so that a
/// mouse stays the smallest.
GuessedPlacement guess_placement(const Model& model, const PlacementChoice& choice = {},
                                 SizeRule rule = SizeRule::kept);

}  // namespace throng::anim
