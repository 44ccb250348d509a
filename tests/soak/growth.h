#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace throng::soak {

/// Follows figures that must not grow, such as the bytes of a process each time it rests. A figure may be larger than
/// the largest value of the warm-up by its slack, and no more.
class Growth {
 public:
  /// Adds a value of a figure. `slack` is in the figure's own unit.
  void add(const std::string& name, std::uint64_t value, std::uint64_t slack);
  /// Ends the warm-up: the values so far say how large each figure is.
  void end_warm_up() { warm_ = true; }

  /// Returns a sentence about the first figure that grew; nothing while none does.
  std::optional<std::string> grown() const;
  /// Returns a line for each figure: the largest value of the warm-up, the largest and the last one since.
  std::string table() const;

 private:
  struct Figure {
    std::string name;
    std::uint64_t slack = 0;
    std::uint64_t warm_up = 0, largest = 0, last = 0;
    std::size_t values = 0;  // since the warm-up
  };
  Figure& figure(const std::string& name);

  std::vector<Figure> figures_;
  bool warm_ = false;
};

}  // namespace throng::soak
