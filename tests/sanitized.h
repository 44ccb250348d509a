#pragma once

namespace throng::test {

/// Whether a sanitizer is at work. It takes terabytes of addresses and keeps what was freed, so no limit of addresses
/// can be set, and memory tells nothing of our own code.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace throng::test
