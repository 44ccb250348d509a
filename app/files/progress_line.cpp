#include "app/files/progress_line.h"

#include <cstdio>

#include "engine/base/files/process.h"

namespace throng::app {

void show_progress(const std::string& text) {
  if (shows_progress()) std::fprintf(stderr, "\r\033[K%s", text.c_str());
}

bool shows_progress() { return is_terminal(standard_error); }

}  // namespace throng::app
