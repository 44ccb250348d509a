#pragma once

#include <cstddef>
#include <cstdint>

/// What libFuzzer and the replay call with each input. Any input is answered or refused; a crash, a report of a
/// sanitizer or an exception is a finding. Returns 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
