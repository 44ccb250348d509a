#include "tests/anim/entity/block_reader.h"

#include <cassert>
#include <cstring>

namespace throng::anim {

std::optional<BlockReader> BlockReader::fetch(const std::byte* block, std::span<std::byte> local) {
  const std::size_t size = reinterpret_cast<const AnimationStateHeader*>(block)->total_size;
  if (size > local.size()) return std::nullopt;
  std::memcpy(local.data(), block, size);
  return BlockReader(*reinterpret_cast<AnimationStateHeader*>(local.data()));
}

std::span<const std::byte> BlockReader::bytes() const {
  return {reinterpret_cast<const std::byte*>(state_), state_->total_size};
}

PoseView BlockReader::pose() const {
  assert(has_transforms());
  const auto components = static_cast<int>(state_->components);
  return {transforms_of(*state_), packet_bytes(components) / sizeof(float), components, state_->bone_count};
}

void BlockReader::put_back(std::byte* block) const { std::memcpy(block, state_, state_->total_size); }

}  // namespace throng::anim
