#pragma once

#include <cstddef>
#include <string>
#include <string_view>

struct XML_ParserStruct;

namespace throng {

/// Returns whether a text with this beginning is XML.
bool is_xml(std::string_view head);

/// The attributes of an element.
class XmlAttributes {
 public:
  /// `pairs` are names and values in turn, up to a null.
  explicit XmlAttributes(const char** pairs) : pairs_(pairs) {}
  /// Returns the value of an attribute; null if there is none.
  const char* of(std::string_view name) const;

 private:
  const char** pairs_;
};

/// Reads XML piece by piece. A DOCTYPE is refused, because its entities could grow without end.
class XmlReader {
 public:
  virtual ~XmlReader();
  XmlReader(const XmlReader&) = delete;
  XmlReader& operator=(const XmlReader&) = delete;

  /// Reads the next piece. Returns false after the first error. `is_last` ends the document.
  bool read(std::string_view text, bool is_last);
  /// The end of a sentence, "line 7: ...; ...". Empty while there is no error.
  const std::string& fault() const { return fault_; }
  /// Returns whether the fault is that the document ends before its root does.
  bool ends_early() const { return ends_early_; }

 protected:
  /// `remedy` is for a document that ends early or is no XML: "export it again".
  explicit XmlReader(std::string remedy);
  /// An element begins; `depth` is 0 at the root.
  virtual void open(const char* name, XmlAttributes attributes, std::size_t depth) = 0;
  virtual void close(const char* /*name*/) {}
  /// Ends the reading, with a fault on this line.
  void stop(const std::string& what);
  /// Returns "line 7: ".
  std::string here() const;

 private:
  struct Events;
  XML_ParserStruct* parser_;
  std::string remedy_, fault_;
  std::size_t depth_ = 0;
  bool ends_early_ = false;
};

}  // namespace throng
