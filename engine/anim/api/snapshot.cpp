#include <cstdint>

#include "throng/crowd.h"

#include "engine/anim/agent/system_snapshot.h"
#include "engine/anim/api/crowd_parts.h"
#include "engine/anim/base/misuse.h"

namespace throng {

struct Snapshot::State {
  anim::SystemSnapshot system;
  detail::AgentNotes notes;
  std::uint64_t crowd = 0;  // CrowdParts::number; 0: nothing was put in
};

Snapshot::Snapshot() : state_(std::make_unique<State>()) {}
Snapshot::~Snapshot() = default;
Snapshot::Snapshot(Snapshot&&) noexcept = default;
Snapshot& Snapshot::operator=(Snapshot&&) noexcept = default;
std::size_t Snapshot::bytes() const { return state_ == nullptr ? 0 : state_->system.bytes(); }

void Crowd::snapshot(Snapshot& into) const {
  if (is_gone("Crowd::snapshot")) return;
  if (into.state_ == nullptr) into.state_ = std::make_unique<Snapshot::State>();
  parts_->system->snapshot(into.state_->system);
  into.state_->notes = parts_->notes;
  into.state_->crowd = parts_->number;
}

Status Crowd::restore(const Snapshot& from) {
  if (parts_ == nullptr) return anim::refuse({"Crowd::restore", detail::was_moved_from});
  if (from.state_ == nullptr) return anim::refuse({"Crowd::restore", "the snapshot was moved from"});
  if (from.state_->crowd != 0 && from.state_->crowd != parts_->number)
    return anim::refuse({"Crowd::restore", "the snapshot is of another crowd"});
  const Status restored = parts_->system->restore(from.state_->system);
  if (restored) parts_->notes = from.state_->notes;
  return restored;
}

}  // namespace throng
