#include "app/files/exit_status.h"

#include <cstdio>

#include "engine/anim/base/plain_text.h"

namespace throng::app {

int end_with(ExitStatus status, std::string_view sentence) {
  std::fprintf(stderr, "throng: %s\n", anim::plain_text(sentence).c_str());
  return status;
}

}  // namespace throng::app
