#include "engine/base/text/size_text.h"

#include <cstdio>

namespace throng {

std::string size_text(std::uint64_t bytes) {
  constexpr const char* units[] = {"KiB", "MiB", "GiB", "TiB"};
  if (bytes < 1024) return std::to_string(bytes) + " B";
  double amount = static_cast<double>(bytes) / 1024;
  int unit = 0;
  for (; amount >= 1024 && unit < 3; ++unit) amount /= 1024;
  char text[32];
  std::snprintf(text, sizeof(text), "%.*f %s", amount < 100 ? 1 : 0, amount, units[unit]);
  return text;
}

}  // namespace throng
