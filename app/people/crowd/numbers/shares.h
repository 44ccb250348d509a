#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "app/character/roles.h"
#include "engine/base/random.h"

namespace throng::app {

/// Deals places out to characters by their shares, kind of place by kind of place.
class ShareDealer {
 public:
  explicit ShareDealer(std::span<const CharacterRoles> characters);

  /// Returns the character of each of `places` places, in a random order: each of `numbers` as often as its share among
  /// them asks for, to the nearest whole number. The next kind of place makes good what one rounds off, so that the
  /// sums over all kinds are exact too. `numbers` may be empty only where there are no places.
  std::vector<std::uint8_t> deal(std::span<const std::uint8_t> numbers, std::size_t places, Random& random);

 private:
  std::vector<double> shares_;
  std::vector<double> owed_;  // [character] places that it has yet to get, or has got too many, if below 0
};

}  // namespace throng::app
