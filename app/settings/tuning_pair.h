#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/settings/option_values.h"
#include "app/settings/settings.h"
#include "engine/base/json/json.h"

namespace throng::app {

/// Two tunings to compare, A and B: one is in use, and the other waits until they change places. There is A alone until
/// the person asks for a copy. The pause and the ways to look at level of detail belong to neither and stay as they
/// are.
class TuningPair {
 public:
  static constexpr std::size_t longest_name = 63;  ///< bytes

  TuningPair() = default;
  TuningPair(const std::optional<Tuning>& other, bool shows_b) : other_(other), shows_b_(shows_b) {}

  [[nodiscard]] bool shows_b() const { return shows_b_; }
  [[nodiscard]] bool has_two() const { return other_.has_value(); }
  /// Returns the tuning that waits, which has_two() must say is there.
  [[nodiscard]] const Tuning& other() const { return *other_; }

  /// Returns the letter of the tuning in use, or of the tuning that waits.
  [[nodiscard]] const char* letter_in_use() const { return letters.at(in_use()); }
  [[nodiscard]] const char* other_letter() const { return letters.at(1 - in_use()); }
  /// Returns the letter with the name that a person gave, if there is one: "A", or "A: baseline".
  [[nodiscard]] std::string title_in_use() const { return title(in_use()); }
  [[nodiscard]] std::string other_title() const { return title(1 - in_use()); }

  /// Brings the tuning that waits into use; does nothing where none waits.
  void change_places(Tuning& tuning);
  /// Makes a copy of the tuning in use wait.
  void copy_to_other(const Tuning& tuning) { other_ = tuning; }
  /// Makes another tuning wait, under its name.
  void take_other(const Tuning& tuning, const std::string& name);
  /// Ends the comparison. The tuning in use stays, as A.
  void forget_other();

  static constexpr std::array<const char*, 2> letters = {"A", "B"};
  std::array<std::string, 2> names;  ///< of A and B, as a person typed them; may be empty

  friend bool operator==(const TuningPair&, const TuningPair&) = default;

 private:
  [[nodiscard]] std::size_t in_use() const { return shows_b_ ? 1 : 0; }
  [[nodiscard]] std::string title(std::size_t place) const;

  std::optional<Tuning> other_;
  bool shows_b_ = false;
};

/// Returns a JSON object: {"in_use": "A", "names": ["baseline", ""], "other": {the values of the one that waits}}.
Json to_json(const TuningPair& pair);
/// Reads such an object. A complaint says what is wrong and what is allowed; then nothing has changed.
Complaint from_json(const Json& json, TuningPair& pair);

/// A value that two tunings do not share, as text with its unit.
struct TuningDifference {
  std::string_view key;
  std::string first, second;
};

/// Returns all values in which two tunings differ, but for values that belong to neither of a pair.
std::vector<TuningDifference> differences(const Tuning& first, const Tuning& second);

}  // namespace throng::app
