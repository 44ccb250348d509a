#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace throng::soak {

/// Follows figures that must not grow, such as the bytes of a process each time it rests. The largest value of the
/// warm-up is what a figure may reach.
/// A figure without slack, such as a count of files, has grown as soon as one value is larger.
/// A figure with slack scatters: it has grown once `patience` values in a row are larger by more than the slack, since
/// what is lost stays lost, while a driver that keeps what it may use again lets go of it.
class Growth {
 public:
  static constexpr std::size_t patience = 8;

  /// Adds a value of a figure. `slack` is in the figure's own unit.
  void add(const std::string& name, std::uint64_t value, std::uint64_t slack);
  /// Ends the warm-up: the values so far say how large each figure is.
  void end_warm_up() { warm_ = true; }

  /// Returns whether the last value of a figure that scatters is above what it may reach.
  bool is_above() const;
  /// Returns a sentence about the first figure that grew; nothing while none does.
  std::optional<std::string> grown() const;
  /// Returns a line for each figure: the largest value of the warm-up; since then the largest, the least of the last
  /// `patience`, and the last one.
  std::string table() const;

 private:
  struct Figure {
    std::string name;
    std::uint64_t slack = 0;
    std::uint64_t warm_up = 0, largest = 0;
    std::vector<std::uint64_t> values;  // since the warm-up

    std::uint64_t least_of_last(std::size_t count) const;
    bool is_above_for(std::size_t count) const { return least_of_last(count) > warm_up + slack; }
    bool has_grown() const;
  };
  Figure& figure(const std::string& name);

  std::vector<Figure> figures_;
  bool warm_ = false;
};

}  // namespace throng::soak
