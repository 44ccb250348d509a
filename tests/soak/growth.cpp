#include "tests/soak/growth.h"

#include <algorithm>
#include <span>

namespace throng::soak {

std::uint64_t Growth::Figure::least_of_last(std::size_t count) const {
  const auto last = std::span(values).last(std::min(count, values.size()));
  return last.empty() ? 0 : *std::ranges::min_element(last);
}

bool Growth::Figure::has_grown() const {
  const std::size_t count = slack > 0 ? patience : 1;
  return values.size() >= count && is_above_for(count);
}

Growth::Figure& Growth::figure(const std::string& name) {
  const auto found = std::ranges::find(figures_, name, &Figure::name);
  if (found != figures_.end()) return *found;
  Figure& added = figures_.emplace_back();
  added.name = name;
  return added;
}

void Growth::add(const std::string& name, std::uint64_t value, std::uint64_t slack) {
  Figure& figure = this->figure(name);
  figure.slack = slack;
  // A figure that comes first after the warm-up begins with its first value.
  if (!warm_ || (figure.values.empty() && figure.warm_up == 0)) {
    figure.warm_up = std::max(figure.warm_up, value);
    return;
  }
  figure.largest = std::max(figure.largest, value);
  figure.values.push_back(value);
}

bool Growth::is_above() const {
  return std::ranges::any_of(figures_, [](const Figure& each) { return each.slack > 0 && each.is_above_for(1); });
}

std::optional<std::string> Growth::grown() const {
  for (const Figure& figure : figures_) {
    if (!figure.has_grown()) continue;
    return figure.name + " grew from " + std::to_string(figure.warm_up) + " to " +
           std::to_string(figure.values.back()) + ", by more than " + std::to_string(figure.slack);
  }
  return {};
}

std::string Growth::table() const {
  std::string text;
  for (const Figure& figure : figures_) {
    text += figure.name + std::string(figure.name.size() < 44 ? 44 - figure.name.size() : 0, ' ');
    for (const std::uint64_t value :
         {figure.warm_up, figure.largest, figure.least_of_last(patience), figure.least_of_last(1)}) {
      const std::string digits = std::to_string(value);
      text += std::string(digits.size() < 13 ? 13 - digits.size() : 1, ' ') + digits;
    }
    text += "  in " + std::to_string(figure.values.size()) + " rounds\n";
  }
  return text;
}

}  // namespace throng::soak
