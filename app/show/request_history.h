#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/show/request/request.h"

namespace throng {
struct Trajectories;
}

namespace throng::app {

class Stage;

/// A recorded crowd; null: none.
using ShownTracks = std::shared_ptr<const Trajectories>;

/// Returns the request that takes another one back, which is not made yet; nothing for a request that passes, such as a
/// push. `tuning` has the values in use.
std::optional<CrowdRequest> answer_to(const CrowdRequest& request, const Stage& stage, const Tuning& tuning);

/// Returns whether a request brings other characters.
bool brings_characters(const CrowdRequest& request);

/// Returns a request that was made as it is to be made again: characters that came of files stay as they are on the
/// stage, whatever lies beside their files by then.
CrowdRequest as_made(const CrowdRequest& request, const Stage& stage);

/// The requests that changed values or characters, to be taken back and made again, the last first. Each step goes from
/// one state that was there to another.
class RequestHistory {
 public:
  static constexpr std::size_t most_steps = 100;

  /// What a person did in one go, such as a drag.
  struct Step {
    std::uint64_t change = 0;
    std::vector<CrowdRequest> back = {}, forth = {};  ///< in the order in which they are to be made
    ShownTracks tracks_back = {}, tracks_forth = {};  ///< to be shown before that; null: there is none to be
  };

  /// Adds a request that was made, and its answer. Requests of one `change` are one step; where it repeats a request
  /// with other values, the last one counts. Steps that were taken back are forgotten.
  void add(CrowdRequest made, CrowdRequest answer, std::uint64_t change);

  /// Adds a step of its own: a recorded crowd, which takes the place of another. Its requests have been made, and take
  /// back, with the crowds shown.
  void add(Step step);

  /// Returns the step that can be taken back, or made again; null where there is none.
  const Step* last() const { return made_ > 0 ? &steps_[made_ - 1] : nullptr; }
  const Step* next() const { return made_ < steps_.size() ? &steps_[made_] : nullptr; }
  /// Notes that last() was taken back, or that next() was made again.
  void took_back() { --made_; }
  void made_again() { ++made_; }

 private:
  std::vector<Step> steps_;
  std::size_t made_ = 0;  // of steps_; those behind it were taken back
};

}  // namespace throng::app
