#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/house/house_rules.h"

namespace throng::house {

/// Returns the text of a header with spaces in place of comments, strings and lines of the preprocessor.
std::string code_of(const SourceFile& file);

/// Returns the place after the brace that closes the one at `open`.
std::size_t after_braces(std::string_view code, std::size_t open);

std::string without_template_arguments(std::string text);

bool is_friend(const std::string& head);

/// Returns whether `head`, a declaration up to its body, its initialiser or its semicolon, is that of a function. A
/// friend function is one too, but for operators.
bool declares_a_method(const std::string& head);

/// Calls visit for each declaration between the braces of a class or a namespace. What stands in a namespace inside is
/// left out.
void for_each_declaration(std::string_view body, bool is_public,
                          const std::function<void(const std::string& head, bool is_public)>& visit);

/// A class and what stands between its braces.
struct ClassBody {
  std::string name;
  std::ptrdiff_t line = 0;
  bool is_struct = false;
  std::string body;
};

/// Returns the classes and structs of a text that code_of() returned, those inside of others too.
std::vector<ClassBody> class_bodies(const std::string& code);

}  // namespace throng::house
