#include "engine/anim/import/memory/memory_account.h"

#include <algorithm>
#include <limits>

namespace throng::import {
namespace {

constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();

std::uint64_t sum(std::uint64_t a, std::uint64_t b) { return b > most - a ? most : a + b; }

std::uint64_t product(std::uint64_t a, std::uint64_t b) { return a != 0 && b > most / a ? most : a * b; }

/// Returns "268.4 MB", in the unit of the limits that people give and read, which is not size_text()'s.
std::string told(std::uint64_t bytes) {
  constexpr std::uint64_t million = 1'000'000;
  if (bytes < million) return std::to_string(bytes) + " bytes";
  const std::uint64_t tenths = bytes / (million / 10);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " MB";
}

}  // namespace

MemoryAccount::MemoryAccount(std::uint64_t limit)
    : is_given_(limit != 0),
      limit_(is_given_ ? limit : basic_memory),
      free_image_memory_(is_given_ ? 0 : most_free_image_memory) {}

void MemoryAccount::add_file(std::uint64_t size, const std::string& name) {
  if (!is_given_) limit_ = sum(limit_, product(size, memory_a_file_byte));
  charge(size, name);
}

void MemoryAccount::charge(std::uint64_t bytes, const std::string& object) {
  if (bytes > left()) refuse(bytes, object);
  held_ += bytes;
}

void MemoryAccount::charge_for_good(std::uint64_t bytes, const std::string& object) {
  if (bytes > left()) refuse(bytes, object);
  for_good_ += bytes;
}

std::uint64_t MemoryAccount::image_share(std::uint64_t encoded, std::size_t images) const {
  if (is_given_) return left();
  constexpr std::uint64_t small_image = std::uint64_t{4} << 20U;  // many of them are no reason to scale one
  const std::uint64_t of_its_file = std::min(product(encoded, memory_a_file_byte / 2), left() / 2);
  return std::max(free_image_memory_ / images, std::min(free_image_memory_ / 2, small_image)) + of_its_file;
}

std::uint64_t MemoryAccount::decoder_memory() const {
  return is_given_ ? left() : std::max(sum(left(), free_image_memory_), most_decoder_memory);
}

void MemoryAccount::count_decoded(std::uint64_t bytes, const std::string& object) {
  if (!is_given_ && decoded_ > sum(limit_, most_decoded_memory)) {
    throw MemoryRefusal(object + " is one too many: the images before it have " + told(decoded_) +
                        " of pixels; use fewer or smaller images, or " + larger_limit);
  }
  decoded_ = sum(decoded_, bytes);
}

void MemoryAccount::charge_for_image(std::uint64_t bytes, const std::string& object) {
  const std::uint64_t free = std::min(bytes, free_image_memory_);
  if (bytes - free > left()) refuse(bytes, object, free);
  free_image_memory_ -= free;
  for_good_ += bytes - free;
}

std::uint64_t MemoryAccount::json_allowance(std::uint64_t text) const {
  return is_given_ ? 0 : std::min(product(text, free_memory_a_json_byte), most_free_json_memory);
}

void MemoryAccount::refuse(std::uint64_t bytes, const std::string& object, std::uint64_t free) const {
  throw MemoryRefusal(object + " needs " + told(bytes) + " of memory, and " + told(sum(left(), free)) +
                      " are left of the " + told(sum(limit_, free)) +
                      " that the import may take; use smaller images or meshes, or " + larger_limit);
}

}  // namespace throng::import
