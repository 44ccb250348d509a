#include "app/people/crowd/numbers/shares.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace throng::app {

ShareDealer::ShareDealer(std::span<const CharacterRoles> characters) : owed_(characters.size(), 0.0) {
  for (const CharacterRoles& character : characters) shares_.push_back(character.share);
}

// One place at a time goes to the character that is owed most; among equals to the first. Sums of fractions differ in
// their last bits, so what is owed is compared in millionths.
std::vector<std::uint8_t> ShareDealer::deal(std::span<const std::uint8_t> numbers, std::size_t places, Random& random) {
  assert(places == 0 || !numbers.empty());
  double sum = 0.0;
  for (const std::uint8_t number : numbers) sum += shares_[number];
  std::vector<std::uint8_t> dealt;
  for (const std::uint8_t number : numbers) {
    owed_[number] += shares_[number] / sum * static_cast<double>(places);
    const auto whole = static_cast<std::size_t>(std::max(0.0, std::floor(owed_[number])));
    dealt.insert(dealt.end(), std::min(whole, places - dealt.size()), number);
  }
  for (const std::uint8_t number : dealt) owed_[number] -= 1.0;
  const auto owed = [&](std::uint8_t number) { return std::llround(owed_[number] * 1e6); };
  while (dealt.size() < places) {
    dealt.push_back(*std::ranges::max_element(numbers, {}, owed));
    owed_[dealt.back()] -= 1.0;
  }
  put_in_random_order(dealt, random);
  return dealt;
}

}  // namespace throng::app
