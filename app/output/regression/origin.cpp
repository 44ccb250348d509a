#include "app/output/regression/origin.h"

#include <array>
#include <cstring>
#include <utility>

#include "app/files/program_version.h"
#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

using OriginMember = std::string PictureOrigin::*;

/// "Software" is the keyword of the PNG standard for the program.
constexpr std::array<std::pair<const char*, OriginMember>, 4> keywords{{{"Software", &PictureOrigin::program},
                                                                        {"Throng context", &PictureOrigin::context},
                                                                        {"Throng renderer", &PictureOrigin::renderer},
                                                                        {"Throng OpenGL", &PictureOrigin::gl_version}}};

/// A driver may say anything, and a PNG takes one line of Latin letters.
std::string plain_letters(const std::string& text) {
  std::string plain;
  for (const char letter : text) plain += letter >= ' ' && letter <= '~' ? letter : '?';
  return plain;
}

}  // namespace

std::vector<render::PngText> texts_of(const PictureOrigin& origin) {
  std::vector<render::PngText> texts;
  for (const auto& [keyword, member] : keywords) {
    if (!(origin.*member).empty()) texts.push_back({keyword, plain_letters(origin.*member)});
  }
  return texts;
}

PictureOrigin origin_of(const DrawnBy& drawn_by) {
  return {.program = "Throng " + program_version() + ", commit " + program_commit(),
          .context = drawn_by.context,
          .renderer = drawn_by.gl_renderer,
          .gl_version = drawn_by.gl_version};
}

std::vector<render::PngText> origin_texts(const DrawnBy& drawn_by) { return texts_of(origin_of(drawn_by)); }

PictureOrigin read_origin(const std::filesystem::path& file) {
  PictureOrigin origin;
  const auto texts = render::read_png_texts(file);
  if (!texts) return origin;
  for (const render::PngText& text : *texts) {
    for (const auto& [keyword, member] : keywords) {
      if (text.keyword == keyword) origin.*member = plain_letters(text.text);
    }
  }
  if (!origin.program.starts_with("Throng ")) origin.program.clear();
  return origin;
}

std::string mesa_version(const std::string& gl_version) {
  const char* const mesa = "Mesa ";
  const std::size_t at = gl_version.find(mesa);
  if (at == std::string::npos) return {};
  const std::size_t from = at + std::strlen(mesa);
  return gl_version.substr(from, gl_version.find(' ', from) - from);
}

std::string origin_text(const PictureOrigin& origin) {
  if (origin.context.empty()) return {};
  const std::string mesa = mesa_version(origin.gl_version);
  return origin.context + ", " + origin.renderer + ", " + (mesa.empty() ? origin.gl_version : "Mesa " + mesa);
}

std::string other_origin(const PictureOrigin& expected, const PictureOrigin& actual) {
  std::vector<std::string> before, now;
  for (const OriginMember member : {&PictureOrigin::context, &PictureOrigin::renderer, &PictureOrigin::gl_version}) {
    if ((expected.*member).empty() || expected.*member == actual.*member) continue;
    before.push_back(expected.*member);
    if (!(actual.*member).empty()) now.push_back(actual.*member);
  }
  if (before.empty()) return {};
  return "the expected picture was made by " + joined(before) + (now.empty() ? "" : ", not " + joined(now));
}

}  // namespace throng::app
