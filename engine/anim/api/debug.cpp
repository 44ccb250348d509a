#include "throng/debug.h"

#include <chrono>

#include "throng/version.h"

#include "engine/anim/api/crowd_parts.h"
#include "engine/anim/kernel/kernels.h"

#define THRONG_TEXT_OF(number) #number
#define THRONG_TEXT(number) THRONG_TEXT_OF(number)

namespace throng {

std::uint64_t Debug::pose_hash() const { return crowd_->system->figures().pose_hash(); }
std::uint32_t Debug::posed_agents() const { return crowd_->system->figures().report().agents_updated; }
double Debug::predicted_nanoseconds() const { return crowd_->system->figures().report().predicted_nanoseconds; }
double Debug::update_milliseconds() const { return crowd_->system->figures().update_time().milliseconds; }
double Debug::bytes_per_agent() const { return crowd_->system->figures().bytes_per_agent(); }
const char* Debug::kernels() const { return crowd_->system->figures().kernels().target; }

std::vector<PuSpan> Debug::trace(int pu) const {
  const anim::Figures figures = crowd_->system->figures();
  if (pu < 0 || static_cast<std::size_t>(pu) >= figures.units().size()) return {};
  const anim::UpdateTime& time = figures.update_time();
  const auto nanoseconds = [&](std::uint64_t tick) {
    const std::chrono::duration<double, std::milli> since(time.ms(tick));
    const auto start = std::chrono::duration_cast<std::chrono::nanoseconds>(time.start.time_since_epoch());
    return std::int64_t{(start + std::chrono::round<std::chrono::nanoseconds>(since)).count()};
  };
  std::vector<PuSpan> spans;
  for (const anim::TraceSpan& one : figures.units()[static_cast<std::size_t>(pu)].trace().spans()) {
    if (one.kind == anim::TraceSpan::Kind::copy_slice) continue;  // it lies within the span that follows
    spans.push_back({.name = anim::name_of(one.kind),
                     .begin = nanoseconds(one.begin),
                     .end = nanoseconds(one.end),
                     .agents = one.content.agents,
                     .bytes_in = one.bytes_in,
                     .bytes_out = one.bytes_out});
  }
  return spans;
}

int version() { return THRONG_VERSION; }

const char* version_text() {
  return THRONG_TEXT(THRONG_VERSION_MAJOR) "." THRONG_TEXT(THRONG_VERSION_MINOR) "." THRONG_TEXT(THRONG_VERSION_PATCH);
}

}  // namespace throng
