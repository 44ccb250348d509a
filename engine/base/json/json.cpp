#include "engine/base/json/json.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "engine/base/json/json_tree.h"

namespace throng {
namespace {

using Native = nlohmann::ordered_json;

const Json null;

}  // namespace

/// Hands the tree over to the library that prints it.
struct JsonPrinter {
  static Native native(const Json& json) { return std::visit(JsonPrinter{}, json.value_); }

  Native operator()(const Json::Array& elements) const {
    Native::array_t array;
    for (const Json& element : elements) array.push_back(native(element));
    return array;
  }
  Native operator()(const Json::Object& members) const {
    Native::object_t object;
    for (const auto& [key, value] : members) object.emplace_back(key, native(value));
    return object;
  }
  Native operator()(const auto& plain) const { return plain; }
};

Json::Json(std::initializer_list<Member> members) : value_(Object(members)) {}

Json Json::array(std::initializer_list<Json> elements) {
  Json json;
  json.value_ = Array(elements);
  return json;
}

Json Json::object() {
  Json json;
  json.value_ = Object();
  return json;
}

bool Json::is_whole(std::int64_t least, std::int64_t most) const {
  return is<std::int64_t>() && get<std::int64_t>() >= least && get<std::int64_t>() <= most;
}

bool Json::are_whole(std::int64_t least, std::int64_t most) const {
  return is_array() && std::ranges::all_of(elements(), [&](const Json& each) { return each.is_whole(least, most); });
}

std::span<const Json> Json::elements() const {
  return is_array() ? std::span<const Json>(*std::get_if<Array>(&value_)) : std::span<const Json>();
}

std::span<const Json::Member> Json::members() const {
  return is_object() ? std::span<const Member>(*std::get_if<Object>(&value_)) : std::span<const Member>();
}

const Json* Json::find(std::string_view key) const {
  const auto found = std::ranges::find(members(), key, &Member::key);
  return found == members().end() ? nullptr : &found->value;
}

const Json& Json::operator[](std::string_view key) const {
  const Json* const found = find(key);
  return found == nullptr ? null : *found;
}

const Json::Member* Json::member_beside(std::initializer_list<std::string_view> known) const {
  const auto found = std::ranges::find_if(
      members(), [&](const Member& member) { return std::ranges::find(known, member.key) == known.end(); });
  return found == members().end() ? nullptr : &*found;
}

Json& Json::operator[](std::string_view key) {
  if (is_null()) value_ = Object();
  assert(is_object());
  auto& members = *std::get_if<Object>(&value_);
  const auto found = std::ranges::find(members, key, &Member::key);
  return found == members.end() ? members.emplace_back(Member{std::string(key), Json()}).value : found->value;
}

Json& Json::push_back(Json element) {
  if (is_null()) value_ = Array();
  assert(is_array());
  return std::get_if<Array>(&value_)->emplace_back(std::move(element));
}

std::string Json::dump(int indent) const {
  return JsonPrinter::native(*this).dump(indent, ' ', false, Native::error_handler_t::replace);
}

Result<Json> parse_json(std::string_view text) {
  constexpr JsonLimits limits{
      .depth = most_json_depth, .bytes = most_json_bytes, .values = most_json_values, .members = most_json_members};
  return parse_json_tree<Json>(text, limits);
}

}  // namespace throng
