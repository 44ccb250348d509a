#include "app/files/exit_status.h"

#include <algorithm>
#include <cstdio>
#include <string>

namespace throng::app {

int end_with(ExitStatus status, std::string_view sentence) {
  std::string line(sentence);
  std::replace_if(
      line.begin(), line.end(), [](unsigned char letter) { return letter < ' '; }, ' ');
  std::fprintf(stderr, "throng: %s\n", line.c_str());
  return status;
}

}  // namespace throng::app
