#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace throng::app::test {

/// An element of an XML text.
struct XmlElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;  ///< between its children, with entities replaced
  std::vector<XmlElement> children;
};

/// Parses a text as XML 1.0 is written, without anything that may be left out: a declaration first, every attribute
/// once and in quotes, every element closed, only the five entities and numbers, no bare & or <, no control characters.
/// Returns nothing where it is not so.
std::optional<XmlElement> parse_strictly(std::string_view text);

}  // namespace throng::app::test
