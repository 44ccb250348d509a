#include "throng/debug.h"

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

int version() { return THRONG_VERSION; }

const char* version_text() {
  return THRONG_TEXT(THRONG_VERSION_MAJOR) "." THRONG_TEXT(THRONG_VERSION_MINOR) "." THRONG_TEXT(THRONG_VERSION_PATCH);
}

}  // namespace throng
