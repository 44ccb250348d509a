#include "app/files/progress_line.h"

#include <cstdio>

#include <unistd.h>

namespace throng::app {

void show_progress(const std::string& text) {
  if (isatty(STDERR_FILENO) == 1) std::fprintf(stderr, "\r\033[K%s", text.c_str());
}

}  // namespace throng::app
