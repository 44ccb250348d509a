#include "engine/anim/base/zone.h"

#include "engine/anim/base/misuse.h"

namespace throng::anim {
namespace {

ZoneHooks zones_of_the_host{};

}  // namespace

const ZoneHooks& zone_hooks() { return zones_of_the_host; }

}  // namespace throng::anim

void throng::set_zone_hooks(const ZoneHooks& hooks) {
  if ((hooks.begin == nullptr) == (hooks.end == nullptr)) {
    anim::zones_of_the_host = hooks;
  } else {
    anim::report_misuse({"set_zone_hooks", "both functions are given, or neither"});
  }
}
