#pragma once

#include <cstddef>

/// Which SIMD targets the kernels are compiled for: all that this compiler can write. SCALAR, one lane wide, is among
/// them, because the tests measure the others against it; Highway would replace it by emulated 128-bit vectors on newer
/// compilers. Each unit of kernels includes this file before Highway.
#define HWY_COMPILE_ALL_ATTAINABLE
#define HWY_BROKEN_EMU128 1

/// Leaves out targets without a width that the compiler knows, since the kernels keep vectors in structures; the
/// extensions of AVX3, which are the bits below it, since kernels of floats are the same on them; and SSSE3, SSE3 and
/// SSE2, which are the bits above SSE4: a processor without SSE4 takes SCALAR.
/// A build that leaves out more defines the macro itself, with these among its targets.
#ifndef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS \
  (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | (HWY_AVX3 - 1) | 7 * HWY_SSSE3)
#endif

#if defined(__aarch64__)
#include <hwy/detect_targets.h>
#if !defined(HWY_NEON_WITHOUT_AES)
// Highway 1.0.3 marks functions for NEON with an attribute, for the sake of AES, which we do not use. Constructors
// that a compiler makes lack the mark, and could not call the vectors' constructors. Without it all is plain NEON.
#undef HWY_HAVE_RUNTIME_DISPATCH
#define HWY_HAVE_RUNTIME_DISPATCH 0
#define THRONG_PLAIN_NEON 1
#endif
#endif
