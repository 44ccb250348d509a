#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/base/result.h"

namespace throng {

/// The limits of parse_json_tree(): of nesting, of the text, of all values, and of the members of one object.
struct JsonLimits {
  std::size_t depth, bytes, values, members;
};

/// Builds a tree as the parser comes by, and stops it at the first limit.
template <typename Tree>
class JsonTreeBuilder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  JsonTreeBuilder(std::string_view text, const JsonLimits& limits) : text_(text), limits_(limits) {}

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(std::int64_t value) override { return add(value); }
  bool number_unsigned(std::uint64_t value) override { return add(value); }
  bool number_float(double value, const std::string& /*digits*/) override { return add(value); }
  bool string(std::string& value) override { return add(std::move(value)); }
  bool binary(nlohmann::json::binary_t& /*value*/) override { return false; }
  bool start_object(std::size_t /*size*/) override { return open(Tree::object()); }
  bool start_array(std::size_t /*size*/) override { return open(Tree::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(std::string& key) override {
    key_ = std::move(key);
    if (members_of(*parents_.back()) < limits_.members) return true;
    error_ = "has an object of more than " + std::to_string(limits_.members) + " members";
    return false;
  }
  bool parse_error(std::size_t position, const std::string& /*token*/,
                   const nlohmann::json::exception& error) override {
    const std::string_view read = text_.substr(0, std::min(position, text_.size() + 1) - 1);
    const auto line = 1 + std::ranges::count(read, '\n');
    const std::size_t column = read.size() - (read.rfind('\n') + 1) + 1;
    const bool is_number = dynamic_cast<const nlohmann::json::out_of_range*>(&error) != nullptr;
    error_ = (is_number ? "has a number that is too large at line " : "is not JSON at line ") + std::to_string(line) +
             ", column " + std::to_string(column);
    return false;
  }

  Result<Tree> result() && { return error_.empty() ? Result<Tree>(std::move(root_)) : Error{error_}; }

 private:
  static std::size_t members_of(const Tree& tree) {
    if constexpr (requires { tree.members(); }) {
      return tree.members().size();
    } else {
      return tree.size();
    }
  }
  // A parent keeps its place while its children are built: nothing is added to its own parent meanwhile.
  Tree& place(Tree value) {
    if (parents_.empty()) return root_ = std::move(value);
    Tree& parent = *parents_.back();
    if (parent.is_object()) return parent[key_] = std::move(value);
    if constexpr (requires { parent.back(); }) {
      return parent.emplace_back(std::move(value));
    } else {
      return parent.push_back(std::move(value));
    }
  }
  Tree* counted(Tree value) {
    if (values_++ == limits_.values) {
      error_ = "has more than " + std::to_string(limits_.values) + " values";
      return nullptr;
    }
    return &place(std::move(value));
  }
  bool add(Tree value) { return counted(std::move(value)) != nullptr; }
  bool open(Tree empty) {
    if (parents_.size() == limits_.depth) {
      error_ = "is nested deeper than " + std::to_string(limits_.depth) + " levels";
      return false;
    }
    parents_.push_back(counted(std::move(empty)));
    return parents_.back() != nullptr;
  }
  bool close() {
    parents_.pop_back();
    return true;
  }

  std::string_view text_;
  JsonLimits limits_;
  Tree root_;
  std::vector<Tree*> parents_;
  std::size_t values_ = 0;
  std::string key_, error_;
};

/// Parses a text: no other code of the project parses JSON. The last of doubled keys counts. A Tree is Json, or the
/// one of the library that parses, which glTF uses. Errors are the ends of sentences: "is not JSON at line 2, column
/// 5".
template <typename Tree>
Result<Tree> parse_json_tree(std::string_view text, const JsonLimits& limits) {
  if (text.size() > limits.bytes) return Error{"is longer than " + std::to_string(limits.bytes) + " bytes"};
  JsonTreeBuilder<Tree> builder(text, limits);
  nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  return std::move(builder).result();
}

}  // namespace throng
