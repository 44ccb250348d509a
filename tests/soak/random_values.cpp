#include "tests/soak/random_values.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace throng::soak {
namespace {

struct Limit {
  std::string_view key;
  double most;
};
constexpr Limit limits[] = {{"agents", 2000}, {"pus", 12}, {"local_store_kib", 4096}};

double most_of(const app::TuningValue& value) {
  const auto* const found = std::ranges::find(limits, value.key, &Limit::key);
  return found == std::end(limits) ? value.most : std::min(found->most, value.most);
}

/// Returns the words in a phrase such as "0, 1 or 2".
std::vector<std::string> words_in(std::string phrase) {
  if (const std::size_t last = phrase.rfind(" or "); last != std::string::npos) phrase.replace(last, 4, ",");
  std::vector<std::string> words;
  for (std::string word : app::parts_between_commas(phrase)) {
    std::erase(word, ' ');
    words.push_back(std::move(word));
  }
  return words;
}

std::string any_number_of(const app::TuningValue& value, Random& random) {
  const double number = any_number(random, value.least, most_of(value));
  const std::string fraction = app::shortest_text(static_cast<float>(number));
  app::Tuning tuning;
  const bool taken = random.chance(0.5F) && !value.read(tuning, fraction);
  return taken ? fraction : std::to_string(std::llround(number));
}

}  // namespace

double any_number(Random& random, double least, double most) {
  if (random.chance(0.1F)) return least;
  if (random.chance(0.1F)) return most;
  if (least < 0) return least + (most - least) * static_cast<double>(random.unit());
  const double lowest = std::max(least, most * 1e-6);
  const double number = lowest * std::pow(most / lowest, static_cast<double>(random.unit()));
  return std::clamp(number, least, most);
}

int any_whole_number(Random& random, int least, int most) {
  return static_cast<int>(std::lround(any_number(random, least, most)));
}

std::string any_text_of(const app::TuningValue& value, Random& random) {
  if (value.least == value.most) return any_of(random, words_in(value.values));
  return any_number_of(value, random);
}

void change_some_values(app::Tuning& tuning, Random& random) {
  for (const app::TuningValue& value : app::tuning_values()) {
    if (!random.chance(0.33F)) continue;
    const std::string text = any_text_of(value, random);
    const app::Complaint complaint = value.read(tuning, text);
    assert(!complaint);
    static_cast<void>(complaint);
  }
}

}  // namespace throng::soak
