#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace throng {

/// Gives each id of a file a number, in the order in which ids come.
class IdTable {
 public:
  /// Returns the number of an id, which is a new one if the id was not seen before.
  std::uint32_t number_of(std::string_view id);
  std::uint32_t number_of(std::int64_t id);  ///< of its digits
  std::size_t size() const { return ids_.size(); }
  const std::string& id(std::uint32_t number) const { return ids_[number]; }

 private:
  void grow();

  std::vector<std::string> ids_;
  std::vector<std::uint64_t> hashes_;  // of ids_
  std::vector<std::uint32_t> slots_;   // open addressing: a number and 1, or 0; a power of two, at most half full
};

}  // namespace throng
