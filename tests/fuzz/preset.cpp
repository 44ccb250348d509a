// Presets: what is read is written again, and reads as the same.

#include "app/settings/preset.h"

#include <cstdlib>
#include <string_view>

#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace throng::app;
  Preset preset;
  if (from_json_text({reinterpret_cast<const char*>(data), size}, preset)) return 0;
  Preset again;
  if (from_json(to_json(preset), again)) std::abort();
  return 0;
}
