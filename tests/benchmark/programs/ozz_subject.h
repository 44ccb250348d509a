#pragma once

#include <memory>
#include <span>

#include "app/commands/bench/crowd.h"
#include "engine/anim/asset/model.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// Animates the same crowd, clips, times and weights by ozz-animation, on one thread: two samplings, a blend, model
/// space, palettes.
class OzzSubject {
 public:
  virtual ~OzzSubject() = default;
  virtual void run() = 0;
};

/// Makes the subject. Errors: no ozz was installed when this was built, or it cannot play the model as it is (matrices,
/// scale, keys that are not LINEAR).
anim::Result<std::unique_ptr<OzzSubject>> make_ozz_subject(const anim::Model& model, std::span<const BenchAgent> agents,
                                                           const BenchPalettes& palettes);

}  // namespace throng::app
