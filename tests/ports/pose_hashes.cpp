// Poses the crowds of tests/anim/agent/hashed_crowds.h on each SIMD target that this machine runs, and prints a line a
// target: its name, `fused` where it has fused multiply-add, else `apart`, and two hashes a crowd, of sampled streams
// and of keyframes. `scripts/targets` lays such lines of several builds side by side.
#include <cinttypes>
#include <cstdio>

#include "engine/anim/kernel/kernels.h"
#include "tests/anim/agent/hashed_crowds.h"

int main() {
  using namespace throng::anim;
  for (const Kernels& kernels : runnable_kernels()) {
    std::printf("%-8s %s", kernels.target, kernels.fused_multiply_add ? "fused" : "apart");
    for (const HashedCrowd& crowd : hashed_crowds()) {
      for (const StreamKind stream : {StreamKind::sampled, StreamKind::keyframe}) {
        std::printf(" %016" PRIx64, crowd.hash_of({.stream = stream, .kernels = &kernels}));
      }
    }
    std::printf("\n");
  }
}
