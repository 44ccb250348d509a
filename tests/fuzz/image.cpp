// Images as models hold them: PNG, JPEG, WebP; all else is refused.

#include "engine/anim/import/pixels/decode.h"
#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::uint64_t budget = 16'000'000;
  try {
    static_cast<void>(throng::import::decode_image(std::as_bytes(std::span(data, size)), budget));
  } catch (const throng::import::OverBudget&) {
    return 0;  // which import turns into its refusal
  }
  return 0;
}
