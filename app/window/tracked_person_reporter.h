#pragma once

#include <cstdint>
#include <memory>

#include "app/show/report/tracked_person.h"

namespace throng::app {

class Stage;

/// Reports the selected person of a recorded crowd. Facts that follow from the file are found once. Footfalls of a long
/// time are found in the frames after that, so that no frame waits for them.
class TrackedPersonReporter {
 public:
  /// Returns the selected person as far as it is known; null where no person of a recorded crowd is selected, or where
  /// its rows still come.
  std::shared_ptr<const TrackedPerson> report(const Stage& stage);

 private:
  void begin(const Stage& stage, std::uint32_t agent);
  void find_footfalls(const Stage& stage);

  std::shared_ptr<TrackedPerson> person_;
  std::uint32_t agent_ = 0;
  std::uint64_t crowd_ = 0;  // AnimatedCrowd::number
  double searched_ = 0.0;    // seconds of the file's clock, until where footfalls are known
};

}  // namespace throng::app
