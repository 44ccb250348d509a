#include "engine/tracks/id_table.h"

#include <charconv>
#include <cstring>
#include <iterator>

namespace throng {
namespace {

std::uint64_t hash_of_id(std::string_view id) {
  std::uint64_t hash = id.size() * 0x9E3779B97F4A7C15U;
  while (!id.empty()) {
    std::uint64_t piece = 0;
    const std::size_t size = id.size() < sizeof(piece) ? id.size() : sizeof(piece);
    std::memcpy(&piece, id.data(), size);
    hash = (hash ^ piece) * 0xFF51AFD7ED558CCDU;
    hash ^= hash >> 32U;
    id.remove_prefix(size);
  }
  return hash;
}

}  // namespace

std::uint32_t IdTable::number_of(std::string_view id) {
  if (ids_.size() * 2 >= slots_.size()) grow();
  const std::uint64_t hash = hash_of_id(id);
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash & mask;
  for (; slots_[slot] != 0; slot = (slot + 1) & mask) {
    const std::uint32_t number = slots_[slot] - 1;
    if (hashes_[number] == hash && ids_[number] == id) return number;
  }
  ids_.emplace_back(id);
  hashes_.push_back(hash);
  slots_[slot] = static_cast<std::uint32_t>(ids_.size());
  return slots_[slot] - 1;
}

std::uint32_t IdTable::number_of(std::int64_t id) {
  char digits[32];
  const char* const end = std::to_chars(digits, std::end(digits), id).ptr;
  return number_of(std::string_view(digits, static_cast<std::size_t>(end - digits)));
}

void IdTable::grow() {
  slots_.assign(slots_.empty() ? 256 : slots_.size() * 2, 0);
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t number = 0; number < ids_.size(); ++number) {
    std::size_t slot = hashes_[number] & mask;
    while (slots_[slot] != 0) slot = (slot + 1) & mask;
    slots_[slot] = static_cast<std::uint32_t>(number + 1);
  }
}

}  // namespace throng
