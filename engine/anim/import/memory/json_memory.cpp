#include "engine/anim/import/memory/json_memory.h"

namespace throng::import {
namespace {

// These are bytes, with the heap's overhead.
constexpr std::uint64_t an_object = 64;
constexpr std::uint64_t an_array = 48;
constexpr std::uint64_t a_member = 112;   // a node of a tree, with a short key and a value
constexpr std::uint64_t an_element = 32;  // a value in an array that has grown
constexpr std::uint64_t a_text = 48;

}  // namespace

std::uint64_t parsed_json_memory(std::string_view text) {
  std::uint64_t bytes = an_element;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      ++bytes;
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
      continue;
    }
    switch (c) {
      case '"':
        in_string = true;
        bytes += a_text;
        break;
      case '{':
        bytes += an_object;
        break;
      case '[':
        bytes += an_array;
        break;
      case ':':
        bytes += a_member;
        break;
      case ',':
        bytes += an_element;
        break;
      default:
        break;
    }
  }
  return bytes;
}

}  // namespace throng::import
