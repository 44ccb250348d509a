#pragma once

#define THRONG_VERSION_MAJOR 1
#define THRONG_VERSION_MINOR 0
#define THRONG_VERSION_PATCH 0
/// Grows with each version: 10,000 a major one, 100 a minor one.
#define THRONG_VERSION (THRONG_VERSION_MAJOR * 10000 + THRONG_VERSION_MINOR * 100 + THRONG_VERSION_PATCH)

namespace throng {

/// Returns THRONG_VERSION of the library that is linked. It differs from the macro where a program was compiled with
/// the headers of another version.
int version();

/// Returns the version as text, "1.0.0".
const char* version_text();

}  // namespace throng
