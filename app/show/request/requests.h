#pragma once

#include <type_traits>
#include <variant>
#include <vector>

#include "app/show/request/request.h"

namespace throng::app {

/// The requests of a frame, in order.
class Requests {
 public:
  /// Adds a request of any kind behind the others.
  void ask(Request request);

  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }

 private:
  std::vector<Request> all_;
};

template <typename Asked, typename Set>
inline constexpr bool is_among = false;
template <typename Asked, typename... All>
inline constexpr bool is_among<Asked, std::variant<All...>> = (std::is_same_v<Asked, All> || ...);

/// Returns the request as one of its kind; null where it is of another.
template <typename Asked>
const Asked* as(const Request& request) {
  const auto find = [](const auto& set) -> const Asked* {
    if constexpr (is_among<Asked, std::decay_t<decltype(set)>>) return std::get_if<Asked>(&set);
    return nullptr;
  };
  return std::visit(find, request);
}

/// Returns the last request of its kind in a list; null where there is none.
template <typename Asked>
const Asked* last_of(const Requests& requests) {
  const Asked* last = nullptr;
  for (const Request& request : requests) {
    if (const auto* const found = as<Asked>(request)) last = found;
  }
  return last;
}

}  // namespace throng::app
