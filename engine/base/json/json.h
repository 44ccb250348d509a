#pragma once

#include <cassert>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "engine/base/result.h"

namespace throng {

/// The limits of parse_json(), which refuses deeper nesting, longer texts, more values, and more members of an object.
inline constexpr std::size_t most_json_depth = 64;
inline constexpr std::size_t most_json_bytes = std::size_t{16} << 20U;
inline constexpr std::size_t most_json_values = std::size_t{1} << 20U;
inline constexpr std::size_t most_json_members = 1000;  // each is looked for among the members before it

template <class T>
concept JsonNumber = std::is_arithmetic_v<T>;
template <class T>
concept JsonList = !std::convertible_to<T, std::string_view> && requires(const T& list) {
  list.begin() != list.end();
};

/// A JSON value: null, a bool, a number, a string, an array, or an object that keeps the order of its members.
/// Braces make objects: Json row = {{"level", 1}, {"bones", {{"kept", 20}}}}; lists of values become arrays.
class Json {
 public:
  struct Member;
  using Array = std::vector<Json>;
  using Object = std::vector<Member>;

  // The constructors are defined below Member, whose size they need.
  Json() = default;
  Json(std::nullptr_t);
  template <JsonNumber T>
  Json(T value);
  Json(std::string text);
  Json(std::string_view text);
  Json(const char* text);
  Json(std::initializer_list<Member> members);
  /// Makes a null where `value` has none.
  template <class T>
  Json(const std::optional<T>& value);
  template <JsonList T>
  Json(const T& list);
  static Json array(std::initializer_list<Json> elements = {});
  static Json object();

  bool is_null() const { return has<std::nullptr_t>(); }
  bool is_number() const { return is_float() || has<std::int64_t>() || has<std::uint64_t>(); }
  bool is_float() const { return has<double>(); }
  /// Returns whether it is an integer from `least` to `most`.
  bool is_whole(std::int64_t least, std::int64_t most) const;
  bool is_array() const { return has<Array>(); }
  bool is_object() const { return has<Object>(); }
  /// Returns whether it is an array of such integers, or an empty array.
  bool are_whole(std::int64_t least, std::int64_t most) const;

  /// Returns whether it is a T: a bool, any type of number that can hold it, a string, or a vector of these.
  template <class T>
  bool is() const;
  /// Returns the value as a T, which it must be.
  template <class T>
  T get() const;

  /// Returns the elements of an array; none if it is no array.
  std::span<const Json> elements() const;
  /// Returns the members of an object; none if it is no object.
  std::span<const Member> members() const;
  bool contains(std::string_view key) const { return find(key) != nullptr; }
  /// Returns the member with that key; a null if there is none.
  const Json& operator[](std::string_view key) const;
  /// Returns the member as a T; `otherwise` if there is none or it is no T.
  template <class T>
  T value(std::string_view key, T otherwise) const {
    const Json& found = (*this)[key];
    return found.is<T>() ? found.get<T>() : otherwise;
  }
  /// Returns the first member whose key is none of `known`; null if there is none.
  const Member* member_beside(std::initializer_list<std::string_view> known) const;

  /// Returns the member with that key, after adding it last if there is none. A null becomes an object.
  Json& operator[](std::string_view key);
  /// Adds an element last and returns it. A null becomes an array.
  Json& push_back(Json element);

  /// Returns the text, on one line without spaces, or on many lines with `indent` spaces a level. Bytes that are not
  /// UTF-8 become U+FFFD.
  std::string dump(int indent = -1) const;

  bool operator==(const Json& other) const;

 private:
  friend struct JsonPrinter;
  template <class T>
  bool has() const {
    return std::holds_alternative<T>(value_);
  }
  const Json* find(std::string_view key) const;

  // A whole number that is not negative is unsigned, so that equal numbers are equal values.
  using Variant = std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string, Array, Object>;

  /// libstdc++ 12 believes that a variant of these types always has a value: where memory runs out while it is
  /// copied, it calls the destructor of nothing. An assignment copies before it changes anything.
  struct Value : Variant {
    using Variant::Variant, Variant::operator=;
    // These are defined below Member, too.
    Value() noexcept;
    Value(const Value& other);
    Value(Value&& other) noexcept;
    Value& operator=(const Value& other);
    Value& operator=(Value&& other) noexcept;
    ~Value();
  };
  Value value_;
};

struct Json::Member {
  std::string key;
  Json value;
  bool operator==(const Member& other) const = default;
};

inline Json::Value::Value() noexcept = default;
// NOLINTNEXTLINE(bugprone-copy-constructor-init,readability-redundant-member-init): Value says why.
inline Json::Value::Value(const Value& other) : Variant() { Variant::operator=(other); }
inline Json::Value::Value(Value&& other) noexcept = default;
inline Json::Value& Json::Value::operator=(const Value& other) = default;
inline Json::Value& Json::Value::operator=(Value&& other) noexcept = default;
inline Json::Value::~Value() = default;

inline Json::Json(std::nullptr_t) {}
inline Json::Json(std::string text) : value_(std::move(text)) {}
inline Json::Json(std::string_view text) : value_(std::string(text)) {}
inline Json::Json(const char* text) : value_(std::string(text)) {}
template <class T>
Json::Json(const std::optional<T>& value) {
  if (value) *this = Json(*value);
}
template <JsonList T>
Json::Json(const T& list) : value_(Array(list.begin(), list.end())) {}
inline bool Json::operator==(const Json& other) const { return value_ == other.value_; }

/// Parses `text`. If members have the same key, the last one counts, in the place of the first. The error says the line
/// and column where `text` stops being JSON.
Result<Json> parse_json(std::string_view text);

template <JsonNumber T>
Json::Json(T value) {
  if constexpr (std::same_as<T, bool>) {
    value_ = value;
  } else if constexpr (std::floating_point<T>) {
    value_ = static_cast<double>(value);
  } else if (value < T{}) {
    value_ = static_cast<std::int64_t>(value);
  } else {
    value_ = static_cast<std::uint64_t>(value);
  }
}

template <class T>
bool Json::is() const {
  if constexpr (std::same_as<T, bool> || std::same_as<T, std::string>) {
    return has<T>();
  } else if constexpr (std::floating_point<T>) {
    return is_number();
  } else if constexpr (std::integral<T>) {
    if (const auto* const number = std::get_if<std::int64_t>(&value_)) return std::in_range<T>(*number);
    const auto* const number = std::get_if<std::uint64_t>(&value_);
    return number != nullptr && std::in_range<T>(*number);
  } else {
    for (const Json& element : elements()) {
      if (!element.is<typename T::value_type>()) return false;
    }
    return is_array();
  }
}

template <class T>
T Json::get() const {
  assert(is<T>());
  if constexpr (std::same_as<T, bool> || std::same_as<T, std::string>) {
    return *std::get_if<T>(&value_);
  } else if constexpr (std::is_arithmetic_v<T>) {
    if (const auto* const number = std::get_if<double>(&value_)) return static_cast<T>(*number);
    if (const auto* const number = std::get_if<std::int64_t>(&value_)) return static_cast<T>(*number);
    return static_cast<T>(*std::get_if<std::uint64_t>(&value_));
  } else {
    T list;
    for (const Json& element : elements()) list.push_back(element.get<typename T::value_type>());
    return list;
  }
}

}  // namespace throng
