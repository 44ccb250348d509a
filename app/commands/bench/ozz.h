#pragma once

#include <memory>
#include <span>

#include "app/commands/bench/crowd.h"
#include "engine/anim/asset/model.h"

namespace throng::app {

/// The same crowd, clips, times and weights animated by ozz-animation, one thread: two samplings, a blend, model space,
/// palettes. For comparison only; there where CMake found an installed ozz.
class OzzSubject {
 public:
  virtual ~OzzSubject() = default;
  virtual void run() = 0;
};

/// Null: there is no ozz here, or it cannot play the model as it is (matrices, scale, keys that are not LINEAR).
std::unique_ptr<OzzSubject> make_ozz_subject(const anim::Model& model, std::span<const BenchAgent> agents,
                                             const BenchPalettes& palettes);

}  // namespace throng::app
