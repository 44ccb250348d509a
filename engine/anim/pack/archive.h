#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "engine/anim/base/aligned_bytes.h"
#include "engine/anim/base/units.h"
#include "engine/anim/pack/sections.h"
#include "engine/base/hash.h"

namespace throng::pack {

/// A table is the bytes of one value, its members in the order in which members() names them (tables.h). Three
/// archives go over that one description: PackWriter writes a table, PackReader reads it, and PackLayout hashes its
/// form, by which packs of another version are told.
///
/// Numbers and the like are written as they lie in memory, the elements of a vector in one go. A block, which is used
/// in place, begins at a multiple of anim::block_alignment.
///
/// `Same<T, Value>` says that T is Value, const where it is written.
template <typename T, typename Value>
concept Same = std::is_same_v<std::remove_const_t<T>, Value>;

/// Says whether a type is written as its bytes. It has no padding, whose bytes could be anything.
template <typename T>
inline constexpr bool is_plain = (std::is_arithmetic_v<T> || std::is_enum_v<T>)&&!std::is_same_v<T, bool>;
template <>
inline constexpr bool is_plain<Ticks> = true;
template <glm::length_t size, typename T, glm::qualifier q>
inline constexpr bool is_plain<glm::vec<size, T, q>> = true;
template <typename T, glm::qualifier q>
inline constexpr bool is_plain<glm::qua<T, q>> = true;
template <glm::length_t columns, glm::length_t rows, typename T, glm::qualifier q>
inline constexpr bool is_plain<glm::mat<columns, rows, T, q>> = true;

/// Writes tables one after the other into one section of a pack.
class PackWriter {
 public:
  template <typename... Values>
  void operator()(const Values&... values) {
    (add(values), ...);
  }

  /// Writes bytes that a reader lends.
  void lend(std::span<const std::uint8_t> bytes, const std::shared_ptr<const void>&) { block(std::as_bytes(bytes)); }
  /// Writes a relocatable block; null is a block without bytes.
  template <typename Block>
  void lend_block(const anim::AlignedBytes& bytes) {
    const auto* header = reinterpret_cast<const Block*>(bytes.get());
    block({bytes.get(), header == nullptr ? 0 : header->total_size});
  }

  const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  template <typename T>
  void add(const T& value) {
    if constexpr (is_plain<T>) {
      append(&value, sizeof(T));
    } else {
      describe(*this, value);
    }
  }
  void add(bool value) { add(static_cast<std::uint8_t>(value ? 1 : 0)); }
  void add(const std::string& text) { add_run(std::span(text)); }
  template <typename T, std::size_t size>
  void add(const std::array<T, size>& values) {
    for (const T& value : values) add(value);
  }
  template <typename T>
  void add(const std::optional<T>& value) {
    add(value.has_value());
    if (value) add(*value);
  }
  template <typename T>
  void add(const std::vector<T>& values) {
    if constexpr (is_plain<T>) {
      add_run(std::span(values));
    } else {
      add(std::uint64_t{values.size()});
      for (const T& value : values) add(value);
    }
  }
  template <typename T>
  void add_run(std::span<const T> values) {
    add(std::uint64_t{values.size()});
    append(values.data(), values.size_bytes());
  }
  void append(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  void block(std::span<const std::byte> bytes) {
    add(std::uint64_t{bytes.size()});
    bytes_.resize(block_after(bytes_.size()));
    append(bytes.data(), bytes.size());
  }

  std::vector<std::byte> bytes_;
};

/// Reads tables back. Bytes that end early, or counts that are too large for them, leave the value empty, and fail.
class PackReader {
 public:
  /// `section` begins at a multiple of anim::block_alignment; `lender` keeps it.
  PackReader(std::span<const std::byte> section, std::shared_ptr<const void> lender)
      : section_(section), lender_(std::move(lender)) {}

  template <typename... Values>
  void operator()(Values&... values) {
    (take(values), ...);
  }
  void lend(std::span<const std::uint8_t>& bytes, std::shared_ptr<const void>& lender) {
    const std::span<const std::byte> lent = block();
    bytes = {reinterpret_cast<const std::uint8_t*>(lent.data()), lent.size()};
    lender = lender_;
  }
  template <typename Block>
  void lend_block(anim::AlignedBytes& bytes) {
    const std::span<const std::byte> lent = block();
    if (lent.empty()) return;
    const auto* header = reinterpret_cast<const Block*>(lent.data());
    if (lent.size() < sizeof(Block) || header->total_size != lent.size()) return fail();
    bytes = anim::lend_aligned(lent.data());
  }

  const std::shared_ptr<const void>& lender() const { return lender_; }
  /// Says whether everything that was read was there, and nothing is left.
  bool read_all() const { return !failed_ && at_ == section_.size(); }

 private:
  template <typename T>
  void take(T& value) {
    if constexpr (is_plain<T>) {
      copy(&value, sizeof(T));
    } else {
      describe(*this, value);
    }
  }
  void take(bool& value) {
    std::uint8_t byte = 0;
    take(byte);
    value = byte != 0;
  }
  void take(std::string& text) {
    text.resize(count_of(1));
    copy(text.data(), text.size());
  }
  template <typename T, std::size_t size>
  void take(std::array<T, size>& values) {
    for (T& value : values) take(value);
  }
  template <typename T>
  void take(std::optional<T>& value) {
    bool has_value = false;
    take(has_value);
    value.reset();
    if (has_value) take(value.emplace());
  }
  template <typename T>
  void take(std::vector<T>& values) {
    if constexpr (is_plain<T>) {
      values.resize(count_of(sizeof(T)));
      copy(values.data(), values.size() * sizeof(T));
    } else {
      const std::size_t count = count_of(1);
      values.reserve(std::min(count, most_reserved));
      for (std::size_t i = 0; i < count && !failed_; ++i) take(values.emplace_back());
    }
  }
  // No count is larger than the bytes that are left allow.
  std::size_t count_of(std::size_t least_size) {
    std::uint64_t count = 0;
    take(count);
    if (count <= (section_.size() - at_) / least_size) return static_cast<std::size_t>(count);
    fail();
    return 0;
  }
  std::span<const std::byte> block() {
    const std::size_t size = count_of(1);
    const std::size_t first = block_after(at_);
    if (first > section_.size() || size > section_.size() - first) return fail(), std::span<const std::byte>();
    at_ = first + size;
    return section_.subspan(first, size);
  }
  void copy(void* target, std::size_t size) {
    if (size > section_.size() - at_) return fail();
    if (size > 0) std::memcpy(target, section_.data() + at_, size);
    at_ += size;
  }
  void fail() {
    failed_ = true;
    at_ = section_.size();
  }

  static constexpr std::size_t most_reserved = 4096;  // elements that a count alone may ask memory for

  std::span<const std::byte> section_;
  std::shared_ptr<const void> lender_;
  std::size_t at_ = 0;
  bool failed_ = false;
};

/// Hashes the form of tables: kinds and sizes of all their members, in their order.
class PackLayout {
 public:
  template <typename... Values>
  void operator()(const Values&... values) {
    (add(values), ...);
  }
  void lend(std::span<const std::uint8_t>, const std::shared_ptr<const void>&) { note('b', 1); }
  template <typename Block>
  void lend_block(const anim::AlignedBytes&) {
    note('B', sizeof(Block));
  }
  /// Counts a size that a form depends on and that no member has.
  void note(char kind, std::size_t size) {
    hash_ = chain_hash(hash_, std::uint64_t{static_cast<unsigned char>(kind)} << 56U | size);
  }

  std::uint64_t hash() const { return hash_; }

 private:
  template <typename T>
  void add(const T& value) {
    if constexpr (is_plain<T>) {
      note(std::is_floating_point_v<T> ? 'f' : 'n', sizeof(T));
    } else {
      note('{', 0);
      describe(*this, value);
      note('}', 0);
    }
  }
  void add(const bool&) { note('n', 1); }
  void add(const std::string&) { note('s', 1); }
  template <typename T, std::size_t size>
  void add(const std::array<T, size>&) {
    note('a', size);
    element<T>();
  }
  template <typename T>
  void add(const std::optional<T>&) {
    note('o', 1);
    element<T>();
  }
  template <typename T>
  void add(const std::vector<T>&) {
    note('v', 1);
    element<T>();
  }
  template <typename T>
  void element() {
    add(T{});
  }

  std::uint64_t hash_ = 0;
};

}  // namespace throng::pack
