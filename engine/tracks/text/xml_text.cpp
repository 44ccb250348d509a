#include "engine/tracks/text/xml_text.h"

#include <new>
#include <utility>

#include <expat.h>

#include "engine/tracks/text/head_lines.h"

namespace throng {

bool is_xml(std::string_view head) {
  head.remove_prefix(byte_order_mark(head));
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && head[first] == '<';
}

const char* XmlAttributes::of(std::string_view name) const {
  for (const char** pair = pairs_; *pair != nullptr; pair += 2) {
    if (name == pair[0]) return pair[1];
  }
  return nullptr;
}

/// The functions that the parser calls.
struct XmlReader::Events {
  static void at_start(void* context, const XML_Char* name, const XML_Char** attributes) {
    XmlReader& reader = *static_cast<XmlReader*>(context);
    reader.open(name, XmlAttributes(attributes), reader.depth_++);
  }
  static void at_end(void* context, const XML_Char* name) {
    XmlReader& reader = *static_cast<XmlReader*>(context);
    --reader.depth_;
    reader.close(name);
  }
  static void at_doctype(void* context, const XML_Char* /*name*/, const XML_Char* /*system*/, const XML_Char* /*place*/,
                         int /*has_subset*/) {
    static_cast<XmlReader*>(context)->stop("it has a DOCTYPE, which is not read; take it out");
  }
};

XmlReader::XmlReader(std::string remedy) : parser_(XML_ParserCreate(nullptr)), remedy_(std::move(remedy)) {
  if (parser_ == nullptr) throw std::bad_alloc();
  XML_SetUserData(parser_, this);
  XML_SetStartDoctypeDeclHandler(parser_, Events::at_doctype);
  XML_SetElementHandler(parser_, Events::at_start, Events::at_end);
}

XmlReader::~XmlReader() { XML_ParserFree(parser_); }

bool XmlReader::read(std::string_view text, bool is_last) {
  if (!fault_.empty()) return false;
  const XML_Status status = XML_Parse(parser_, text.data(), static_cast<int>(text.size()), is_last ? 1 : 0);
  if (status != XML_STATUS_OK && fault_.empty()) {
    const XML_Error error = XML_GetErrorCode(parser_);
    ends_early_ =
        is_last && depth_ > 0 &&
        (error == XML_ERROR_NO_ELEMENTS || error == XML_ERROR_UNCLOSED_TOKEN || error == XML_ERROR_PARTIAL_CHAR);
    fault_ = here() + "it is no whole XML (" + XML_ErrorString(error) + "); " + remedy_;
  }
  return fault_.empty();
}

void XmlReader::stop(const std::string& what) {
  if (!fault_.empty()) return;
  fault_ = here() + what;
  XML_StopParser(parser_, XML_FALSE);
}

std::string XmlReader::here() const {
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9  // it deprecates the older function
  const auto line = XML_GetCurrentLineNumber64(parser_);
#else
  const auto line = XML_GetCurrentLineNumber(parser_);
#endif
  return "line " + std::to_string(line) + ": ";
}

}  // namespace throng
