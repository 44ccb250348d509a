#include "engine/anim/import/json/json.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace throng {
namespace {

using Native = nlohmann::ordered_json;

/// Builds the tree as the parser comes by.
class TreeBuilder final : public nlohmann::json_sax<Native> {
 public:
  explicit TreeBuilder(std::string_view text) : text_(text) {}

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(std::int64_t value) override { return add(value); }
  bool number_unsigned(std::uint64_t value) override { return add(value); }
  bool number_float(double value, const std::string& /*digits*/) override { return add(value); }
  bool string(std::string& value) override { return add(std::move(value)); }
  bool binary(Native::binary_t& /*value*/) override { return false; }
  bool start_object(std::size_t /*size*/) override { return open(Json::object()); }
  bool start_array(std::size_t /*size*/) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(std::string& key) override {
    key_ = std::move(key);
    return true;
  }
  bool parse_error(std::size_t position, const std::string& /*token*/, const Native::exception& /*error*/) override {
    const std::string_view read = text_.substr(0, std::min(position, text_.size() + 1) - 1);
    const auto line = 1 + std::ranges::count(read, '\n');
    const std::size_t column = read.size() - (read.rfind('\n') + 1) + 1;
    error_ = "is not JSON at line " + std::to_string(line) + ", column " + std::to_string(column);
    return false;
  }

  Result<Json> result() && { return error_.empty() ? Result<Json>(std::move(root_)) : Error{error_}; }

 private:
  // A parent keeps its place while its children are built: nothing is added to what is around it meanwhile.
  Json& place(Json value) {
    if (parents_.empty()) return root_ = std::move(value);
    Json& parent = *parents_.back();
    if (parent.is_object()) return parent[key_] = std::move(value);
    return parent.push_back(std::move(value));
  }
  bool add(Json value) {
    place(std::move(value));
    return true;
  }
  bool open(Json empty) {
    if (parents_.size() == most_json_depth) {
      error_ = "is nested deeper than " + std::to_string(most_json_depth) + " levels";
      return false;
    }
    parents_.push_back(&place(std::move(empty)));
    return true;
  }
  bool close() {
    parents_.pop_back();
    return true;
  }

  std::string_view text_;
  Json root_;
  std::vector<Json*> parents_;
  std::string key_, error_;
};

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
  if (text.size() > most_json_bytes) return Error{"is too long"};
  TreeBuilder builder(text);
  Native::sax_parse(text.begin(), text.end(), &builder);
  return std::move(builder).result();
}

}  // namespace throng
