#include "engine/anim/import/memory/memory_account.h"

#include <algorithm>
#include <limits>

namespace throng::import {
namespace {

constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();

std::uint64_t sum(std::uint64_t a, std::uint64_t b) { return b > most - a ? most : a + b; }

std::uint64_t product(std::uint64_t a, std::uint64_t b) { return a != 0 && b > most / a ? most : a * b; }

/// Returns "268.4 MB", in the unit of the limits that people give and read, which is not that of size_text().
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

std::uint64_t MemoryAccount::take_image_allowance(std::uint64_t encoded) {
  const std::uint64_t taken = std::min(product(encoded, free_memory_an_image_byte), free_image_memory_);
  free_image_memory_ -= taken;
  return taken;
}

std::uint64_t MemoryAccount::json_allowance(std::uint64_t text) const {
  return is_given_ ? 0 : std::min(product(text, free_memory_a_json_byte), most_free_json_memory);
}

void MemoryAccount::refuse(std::uint64_t bytes, const std::string& object, std::uint64_t free) const {
  throw MemoryRefusal(object + " needs " + told(bytes) + " of memory, and " + told(sum(left(), free)) +
                      " are left of the " + told(sum(limit_, free)) +
                      " that the import may take; use smaller images or meshes, or allow more with " +
                      "--memory-limit");
}

}  // namespace throng::import
