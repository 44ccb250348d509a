#pragma once

#include "throng/standard.h"

namespace throng {

inline constexpr std::int64_t tick_rate = 705'600'000;              ///< ticks a second, as a bare number
inline constexpr std::int64_t most_ticks = std::int64_t{1} << 62U;  ///< longest_time, as a bare number

/// Names the std::chrono::durations, and types like them, that count in integers: hours, milliseconds, the durations of
/// std::chrono::steady_clock, but not floating durations. They become whole ticks.
template <typename Duration>
concept WholeTicks = requires {
  requires std::signed_integral<typename Duration::rep>;
  requires Duration::period::num <= most_ticks / tick_rate / Duration::period::den;
};

/// Counts time in integers, since sums of floats drift. 705,600,000 ticks a second divide evenly by every common frame
/// rate and sample rate (24, 25, 30, 48, 50, 60, 90, 100, 120 Hz; 44.1, 48, 96 kHz).
///
/// No number becomes a time by itself: to_ticks() takes seconds, Ticks{n} takes ticks, and durations of std::chrono
/// convert: `system.advance(16ms)`. Sums must stay within 64 bits, as with integers.
/// `Ticks{}` is 0; `Ticks t;` is not set, since blocks that hold times are plain bytes.
class Ticks {
 public:
  Ticks() = default;
  constexpr explicit Ticks(std::int64_t count) : count_(count) {}
  /// Takes no number of seconds. A compiler names the parameter where `fade = 0.25F` stands.
  template <std::floating_point to_ticks_takes_seconds>
  Ticks(to_ticks_takes_seconds) = delete;

  /// Takes a duration, exactly if it is of milliseconds or longer; else the nearest tick, which is less than a
  /// nanosecond off. A longer duration than longest_time becomes longest_time.
  template <WholeTicks Duration>
  constexpr Ticks(const Duration& duration) : count_(0) {
    constexpr std::int64_t common = std::gcd(tick_rate, std::int64_t{Duration::period::den});
    constexpr std::int64_t ticks = tick_rate / common * Duration::period::num;  // of so many units
    constexpr std::int64_t of_units = Duration::period::den / common;
    constexpr std::int64_t most = most_ticks / ticks;
    const std::int64_t whole = duration.count() / of_units, rest = duration.count() % of_units * ticks;
    const std::int64_t nearest = (rest + (rest < 0 ? -1 : 1) * (of_units / 2)) / of_units;
    count_ = whole >= most ? most_ticks : (whole <= -most ? -most_ticks : whole * ticks + nearest);
  }

  constexpr std::int64_t count() const { return count_; }

  constexpr Ticks& operator+=(Ticks other) { return *this = *this + other; }
  constexpr Ticks& operator-=(Ticks other) { return *this = *this - other; }
  constexpr Ticks& operator%=(Ticks other) { return *this = *this % other; }
  constexpr Ticks operator-() const { return Ticks{-count_}; }
  friend constexpr Ticks operator+(Ticks a, Ticks b) { return Ticks{a.count_ + b.count_}; }
  friend constexpr Ticks operator-(Ticks a, Ticks b) { return Ticks{a.count_ - b.count_}; }

  friend constexpr Ticks operator*(Ticks ticks, std::int64_t times) { return Ticks{ticks.count_ * times}; }
  friend constexpr Ticks operator*(std::int64_t times, Ticks ticks) { return Ticks{times * ticks.count_}; }
  friend constexpr Ticks operator/(Ticks ticks, std::int64_t parts) { return Ticks{ticks.count_ / parts}; }
  /// Says how many times `b` fits into `a`.
  friend constexpr std::int64_t operator/(Ticks a, Ticks b) { return a.count_ / b.count_; }
  friend constexpr Ticks operator%(Ticks a, Ticks b) { return Ticks{a.count_ % b.count_}; }
  // A caller that needs a fraction of a time rounds it, so that a factor of 0.5 is not taken for 0.
  template <std::floating_point Number>
  friend Ticks operator*(Ticks, Number) = delete;
  template <std::floating_point Number>
  friend Ticks operator*(Number, Ticks) = delete;
  template <std::floating_point Number>
  friend Ticks operator/(Ticks, Number) = delete;

  // One by one: clang 14 warns of the zero in comparisons that a three-way one makes.
  friend constexpr bool operator==(Ticks a, Ticks b) { return a.count_ == b.count_; }
  friend constexpr bool operator<(Ticks a, Ticks b) { return a.count_ < b.count_; }
  friend constexpr bool operator>(Ticks a, Ticks b) { return a.count_ > b.count_; }
  friend constexpr bool operator<=(Ticks a, Ticks b) { return a.count_ <= b.count_; }
  friend constexpr bool operator>=(Ticks a, Ticks b) { return a.count_ >= b.count_; }

  /// Writes to any output stream of the standard library, which this header does not include.
  template <typename Stream>
  requires requires { typename Stream::char_type; }
  friend Stream& operator<<(Stream& stream, Ticks ticks) {
    stream << ticks.count_ << " ticks";
    return stream;
  }

 private:
  std::int64_t count_;
};

inline constexpr Ticks ticks_per_second{tick_rate};

/// The longest time that a conversion gives, 207 years. It is half of what 64 bits hold, so two of them can be added.
inline constexpr Ticks longest_time{most_ticks};

/// Rounds to the nearest tick. A longer or infinite time becomes longest_time, and NaN becomes 0.
inline Ticks to_ticks(double seconds) {
  const double ticks = seconds * static_cast<double>(tick_rate);
  if (std::abs(ticks) < static_cast<double>(most_ticks)) return Ticks{std::llround(ticks)};
  if (std::isnan(ticks)) return Ticks{};
  return ticks < 0.0 ? -longest_time : longest_time;
}
inline double to_seconds(Ticks ticks) { return static_cast<double>(ticks.count()) / static_cast<double>(tick_rate); }

}  // namespace throng

/// Gives the limits of Ticks, as for integers: without this they would silently be 0.
template <>
class std::numeric_limits<throng::Ticks> {
 public:
  static constexpr bool is_specialized = true;
  static constexpr throng::Ticks(min)() { return throng::Ticks{(numeric_limits<std::int64_t>::min)()}; }
  static constexpr throng::Ticks lowest() { return (min)(); }
  static constexpr throng::Ticks(max)() { return throng::Ticks{(numeric_limits<std::int64_t>::max)()}; }
};
