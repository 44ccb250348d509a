// Cases of throng check: what is read has options, a picture to expect and a context each.

#include <cstdlib>
#include <string_view>

#include "app/output/regression/cases.h"
#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace throng::app;
  const auto cases = parse_cases({reinterpret_cast<const char*>(data), size}, "folder");
  if (!cases) return cases.error().message.empty() ? std::abort(), 0 : 0;
  if (cases->cases.empty()) std::abort();
  for (const RegressionCase& each : cases->cases) {
    if (each.name.find('/') != std::string::npos || each.contexts.empty() || each.expected.empty()) std::abort();
  }
  return 0;
}
