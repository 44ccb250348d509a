#pragma once

#include "engine/anim/agent/animation_system.h"
#include "engine/render/job_runner.h"

namespace throng::app {

/// Lets the PUs of a stage do the renderer's jobs. The PUs are free for them between updates.
class PuJobs final : public render::JobRunner {
 public:
  /// Takes the PUs of a system, which must outlive what is drawn with them.
  void use(const anim::AnimationSystem& system) { system_ = &system; }

  void run(int count, void (*job)(void* context, int index), void* context) override {
    system_->executor().run(count, {job, context});
  }
  int jobs_at_once() const override { return system_->options().pus; }

 private:
  const anim::AnimationSystem* system_ = nullptr;
};

}  // namespace throng::app
