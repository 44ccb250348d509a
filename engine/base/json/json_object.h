#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/json/json.h"

namespace throng {

/// Reads the members of a JSON object into values of our own. A value stays as it is where there is no such member, or
/// a wrong one. The first wrong member is kept as a complaint, the end of a sentence that begins with the file's name:
/// `state 2: "speed" must be a number`. The reader keeps the complaint, since several objects share it.
class JsonObject {
 public:
  /// `name` says which object it is; it is empty for a whole file. `keys` are all that it may have.
  JsonObject(std::string name, const Json& object, std::initializer_list<std::string_view> keys,
             std::optional<std::string>& complaint);

  bool has(std::string_view key) const { return object_->contains(key); }
  const Json& operator[](std::string_view key) const { return (*object_)[key]; }

  /// Complains where "version" is missing or another number.
  void version(int wanted) const;
  /// Complains about the first of these keys that is missing.
  void need(std::initializer_list<std::string_view> keys) const;
  void text(std::string_view key, std::string& value) const { read(key, value, "a text"); }
  void flag(std::string_view key, bool& value) const { read(key, value, "true or false"); }
  void number(std::string_view key, double& value) const { read(key, value, "a number"); }
  void number(std::string_view key, double& value, double least, double most) const;
  template <std::integral T>
  void whole(std::string_view key, T& value, T least, T most) const {
    if (!has(key)) return;
    const bool fits = (*this)[key].is_whole(static_cast<std::int64_t>(least), static_cast<std::int64_t>(most));
    if (fits) value = (*this)[key].get<T>();
    if (!fits) wrong(key, "a whole number, " + std::to_string(least) + " to " + std::to_string(most));
  }
  void texts(std::string_view key, std::vector<std::string>& values) const { read(key, values, "an array of texts"); }
  void wholes(std::string_view key, std::vector<int>& values, int least, int most) const;
  /// Reads any other T; `expected` says what it is.
  template <typename T>
  void read(std::string_view key, T& value, std::string_view expected) const {
    if (!has(key)) return;
    if (!(*this)[key].is<T>()) return wrong(key, expected);
    value = (*this)[key].get<T>();
  }
  /// Returns the elements of an array; none where there is no array.
  std::span<const Json> elements(std::string_view key) const;
  /// Returns the members of an object; none where there is no object.
  std::span<const Json::Member> members(std::string_view key) const;

  /// Complains that the member must be `expected`.
  void wrong(std::string_view key, std::string_view expected) const;
  /// Complains with this end of a sentence.
  void complain(std::string_view what) const;

 private:
  std::string name_;
  const Json* object_;
  std::optional<std::string>* complaint_;
};

}  // namespace throng
