#include "tests/anim/agent/hashed_crowds.h"

#include <ostream>

#include "tests/anim/agent/every_kind.h"
#include "tests/anim/agent/fading_crowd.h"
#include "tests/anim/agent/held_crowd.h"

namespace throng::anim {
namespace {

std::uint64_t hash_of_fading(const SystemOptions& options) { return hash_of_fading_crowd(options); }

}  // namespace

void PrintTo(const HashedCrowd& crowd, std::ostream* stream) { *stream << crowd.name; }

std::uint64_t hash_of_every_kind(const SystemOptions& options) {
  EveryKind crowd(options);
  crowd.step(90);
  return crowd->figures().pose_hash();
}

std::span<const HashedCrowd> hashed_crowds() {
  static const std::vector<HashedCrowd> crowds = {{"Fading",
                                                   hash_of_fading,
                                                   {16, 32, 128, 512},
                                                   {0x40446bbedad3123dU, 0x66062d42dd96042U},
                                                   {0x276c3f9873c922b3U, 0x55b2b82f1654afceU}},
                                                  {"EveryKind",
                                                   hash_of_every_kind,
                                                   {40, 64, 200, 1024},
                                                   {0x469ab2e25a2c2532U, 0x5877442222cefd9fU},
                                                   {0xd92cebce586b9609U, 0x60810fd382fd46feU}},
                                                  {"Held",
                                                   hash_of_held_crowd,
                                                   {40, 64, 1024},
                                                   {0x25666c5be76ba0aU, 0xef173aefea7a445dU},
                                                   {0xc0f14513fcb8e42eU, 0xdd035f201245531eU}}};
  return crowds;
}

}  // namespace throng::anim
