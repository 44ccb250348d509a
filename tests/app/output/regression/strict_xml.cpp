#include "tests/app/output/regression/strict_xml.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace throng::app::test {
namespace {

/// Reads from the front of a text; nothing it returns is right once `good` is not.
class Reader {
 public:
  explicit Reader(std::string_view text) : left_(text) {}

  bool good() const { return good_; }
  bool at_end() const { return left_.empty(); }
  bool take(std::string_view word) {
    if (!left_.starts_with(word)) return false;
    left_.remove_prefix(word.size());
    return true;
  }
  void need(std::string_view word) { good_ = take(word) && good_; }
  bool skip_spaces() {
    const std::size_t end = std::min(left_.find_first_not_of(" \n"), left_.size());
    left_.remove_prefix(end);
    return end > 0;
  }
  std::string name() {
    std::size_t end = 0;
    while (end < left_.size() && std::isalpha(static_cast<unsigned char>(left_[end])) != 0) ++end;
    const std::string name(left_.substr(0, end));
    good_ = good_ && end > 0;
    left_.remove_prefix(end);
    return name;
  }
  /// Reads characters up to one of `ends`, which is left.
  std::string characters(char end) {
    std::string text;
    while (good_ && !left_.empty() && left_.front() != end) {
      const char letter = left_.front();
      good_ = letter != '<' && (static_cast<unsigned char>(letter) >= ' ' || letter == '\n');
      if (letter == '&') {
        text += entity();
        continue;
      }
      text += letter;
      left_.remove_prefix(1);
    }
    good_ = good_ && !left_.empty();
    return text;
  }

 private:
  char entity() {
    for (const auto& [word, letter] : {std::pair{"&amp;", '&'}, std::pair{"&lt;", '<'}, std::pair{"&gt;", '>'},
                                       std::pair{"&quot;", '"'}, std::pair{"&#39;", '\''}}) {
      if (take(word)) return letter;
    }
    good_ = false;
    return '?';
  }

  std::string_view left_;
  bool good_ = true;
};

void read_attributes(Reader& reader, XmlElement& element) {
  while (reader.good() && reader.skip_spaces()) {
    const std::string name = reader.name();
    reader.need("=\"");
    if (!element.attributes.emplace(name, reader.characters('"')).second) reader.need("an attribute twice");
    reader.need("\"");
  }
}

XmlElement read_element(Reader& reader) {
  XmlElement element{.name = reader.name(), .attributes = {}, .text = {}, .children = {}};
  read_attributes(reader, element);
  if (reader.take("/>")) return element;
  reader.need(">");
  while (reader.good()) {
    element.text += reader.characters('<');
    if (reader.take("</")) break;
    reader.need("<");
    element.children.push_back(read_element(reader));
  }
  if (reader.name() != element.name) reader.need("the end of it");
  reader.need(">");
  return element;
}

}  // namespace

std::optional<XmlElement> parse_strictly(std::string_view text) {
  Reader reader(text);
  reader.need("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<");
  if (!reader.good()) return {};
  XmlElement root = read_element(reader);
  reader.need("\n");
  return reader.good() && reader.at_end() ? std::optional(std::move(root)) : std::nullopt;
}

}  // namespace throng::app::test
