#include "app/people/wardrobe/face.h"

#include <cmath>

#include "app/people/crowd/numbers/random.h"

namespace throng::app {
namespace {

constexpr std::uint64_t face_stream = 27, stoop_stream = 28;

std::uint32_t signed_byte(float value) {
  return static_cast<std::uint8_t>(static_cast<std::int8_t>(std::lround(value * 127.0F)));
}

}  // namespace

void give_face(render::AgentLook& look, std::uint32_t agent, std::uint32_t seed, bool is_child) {
  Random random(seed + agent, face_stream);
  const float reach = is_child ? 0.4F : 1.0F;
  look.face = 0;
  for (const unsigned shift : {0U, 8U, 16U, 24U}) look.face |= signed_byte(random.between(-reach, reach)) << shift;
}

void stoop(render::AgentLook& look, std::uint32_t agent, std::uint32_t seed) {
  constexpr std::uint32_t posture = 0xFF0000;
  Random random(seed + agent, stoop_stream);
  look.shape = (look.shape & ~posture) | signed_byte(random.between(0.55F, 1.0F)) << 16U;
}

}  // namespace throng::app
