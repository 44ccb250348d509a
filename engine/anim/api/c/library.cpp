#include "engine/anim/api/c/parts.h"

namespace throng::c {
namespace {

std::string& last_error() {
  static thread_local std::string error;
  return error;
}

}  // namespace

int fail(std::string why) {
  last_error() = std::move(why);
  return failed;
}

}  // namespace throng::c

using namespace throng::c;  // NOLINT: functions of C have no namespace

int throng_version(void) { return version(); }
const char* throng_version_text(void) { return version_text(); }
const char* throng_last_error(void) { return last_error().c_str(); }
