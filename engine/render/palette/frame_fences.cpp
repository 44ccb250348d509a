#include "engine/render/palette/frame_fences.h"

#include <algorithm>
#include <cassert>

namespace throng::render {
namespace {

bool is_signalled(GLenum outcome) { return outcome == GL_ALREADY_SIGNALED || outcome == GL_CONDITION_SATISFIED; }

}  // namespace

FrameFences::~FrameFences() {
  for (const Pending& pending : pending_) glDeleteSync(pending.sync);
}

void FrameFences::insert(std::uint64_t frame) {
  assert(frame > 0 && frame >= completed_ && (pending_.empty() || frame >= pending_.back().frame));
  completed_ = std::min(completed_, frame - 1);
  if (!pending_.empty() && pending_.back().frame == frame) {
    glDeleteSync(pending_.back().sync);
    pending_.pop_back();
  }
  pending_.push_back({frame, glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)});
}

std::uint64_t FrameFences::poll() {
  while (!pending_.empty() && is_signalled(glClientWaitSync(pending_.front().sync, GL_SYNC_FLUSH_COMMANDS_BIT, 0))) {
    completed_ = pending_.front().frame;
    glDeleteSync(pending_.front().sync);
    pending_.pop_front();
  }
  return completed_;
}

}  // namespace throng::render
