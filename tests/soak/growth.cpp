#include "tests/soak/growth.h"

#include <algorithm>
#include <cstdio>

namespace throng::soak {

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
  if (!warm_ || (figure.values == 0 && figure.warm_up == 0)) {
    figure.warm_up = std::max(figure.warm_up, value);
    return;
  }
  figure.largest = std::max(figure.largest, value);
  figure.last = value;
  ++figure.values;
}

std::optional<std::string> Growth::grown() const {
  for (const Figure& figure : figures_) {
    if (figure.largest <= figure.warm_up + figure.slack) continue;
    return figure.name + " grew from " + std::to_string(figure.warm_up) + " to " + std::to_string(figure.largest) +
           ", by more than " + std::to_string(figure.slack);
  }
  return {};
}

std::string Growth::table() const {
  std::string text;
  for (const Figure& figure : figures_) {
    char line[200];
    std::snprintf(line, sizeof(line), "%-44s %12llu %12llu %12llu %7zu\n", figure.name.c_str(),
                  static_cast<unsigned long long>(figure.warm_up), static_cast<unsigned long long>(figure.largest),
                  static_cast<unsigned long long>(figure.last), figure.values);
    text += line;
  }
  return text;
}

}  // namespace throng::soak
