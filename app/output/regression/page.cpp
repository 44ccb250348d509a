#include "app/output/regression/page.h"

#include <string>
#include <string_view>
#include <utility>

#include "app/files/program_version.h"
#include "app/output/regression/markup.h"
#include "app/output/regression/page_look.h"
#include "engine/base/files/input_file.h"
#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

/// Puts the parts of a page into its file, one after another: pictures are large.
class PageWriter {
 public:
  explicit PageWriter(OutputFile& file) : file_(&file) {}

  void put(std::string_view text) {
    if (outcome_) outcome_ = file_->write(text);
  }
  /// Puts a picture inside the page. Where it cannot be read any more, a sentence takes its place.
  void image(const std::filesystem::path& file, const std::string& classes, const std::string& label) {
    constexpr std::size_t most_bytes = std::size_t{1} << 30U;
    const auto bytes = read_file(file, "a .png", most_bytes);
    if (!bytes) return put("<p>" + escaped(file.string() + ": " + bytes.error().message) + "</p>");
    put("<img class=\"" + classes + "\" alt=\"" + label + "\" src=\"data:image/png;base64,");
    put(in_base64(std::as_bytes(std::span(*bytes))));
    put("\">");
  }
  const Status& outcome() const { return outcome_; }

 private:
  OutputFile* file_;
  Status outcome_ = Done{};
};

/// "NOT DRAWN" as a class of the style sheet: "not-drawn".
std::string class_of(Verdict verdict) {
  std::string name = word_of(verdict);
  for (char& letter : name) {
    if (letter == ' ') letter = '-';
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return name;
}

void put_figures(PageWriter& page, const CaseOutcome& outcome) {
  if (outcome.figures.empty()) return;
  page.put("<table><tr><th>figure</th><th>measured</th><th>at most</th><th>because</th></tr>");
  for (const JudgedFigure& figure : outcome.figures) {
    page.put("<tr><td>" + escaped(figure.name) + "</td><td" + (figure.is_within ? "" : " class=\"beyond\"") + ">" +
             escaped(figure.value) + "</td><td>" + (figure.limit.empty() ? "no limit" : escaped(figure.limit)) +
             "</td><td>" + escaped(figure.because) + "</td></tr>");
  }
  page.put("</table>");
}

void put_button(PageWriter& page, const std::string& what, const std::string& label, bool pressed) {
  page.put("<button type=\"button\" data-show=\"" + what + "\" aria-pressed=\"" + (pressed ? "true" : "false") + "\">" +
           label + "</button>");
}

constexpr std::string_view zoom_button =
    "<button type=\"button\" class=\"zoom\" aria-pressed=\"false\">True size</button>";

/// Both pictures on each other, and their difference over them.
void put_pair(PageWriter& page, const CaseOutcome& outcome) {
  page.put("<div class=\"view\"><div class=\"choices\">");
  put_button(page, "slider", "Slider", true);
  put_button(page, "expected", "Expected", false);
  put_button(page, "actual", "Actual", false);
  if (!outcome.difference.empty()) put_button(page, "difference", "Difference, 8 times as bright", false);
  if (!outcome.heat.empty()) put_button(page, "heat", "Heat map", false);
  page.put(zoom_button);
  page.put("</div><div class=\"wide\"><div class=\"stage\"><div class=\"frame\" data-shown=\"slider\">");
  page.image(outcome.expected, "expected", "the expected picture");
  page.image(outcome.actual, "over actual", "the picture that was drawn");
  if (!outcome.difference.empty()) page.image(outcome.difference, "over difference", "their difference");
  if (!outcome.heat.empty()) page.image(outcome.heat, "over heat", "a heat map of their difference");
  page.put(
      "<div class=\"divider\"></div><span class=\"side left\">expected</span>"
      "<span class=\"side right\">actual</span></div>"
      "<input class=\"slide\" type=\"range\" min=\"0\" max=\"100\" step=\"0.1\" value=\"50\" "
      "aria-label=\"where the expected picture ends\">"
      "<p class=\"key\">Grey is the same, blue a step of 255, yellow 32, red 64 and more. The frame is around the "
      "worst block.</p></div></div></div>");
}

/// Pictures of two sizes, which cannot lie on each other, or the only picture.
void put_apart(PageWriter& page, const CaseOutcome& outcome) {
  for (const auto& [file, label] : {std::pair{&outcome.expected, "expected"}, std::pair{&outcome.actual, "actual"}}) {
    if (file->empty()) continue;
    page.put("<div class=\"view\"><div class=\"choices\"><span>" + std::string(label) + "</span>");
    page.put(zoom_button);
    page.put("</div><div class=\"wide\"><div class=\"frame\">");
    page.image(*file, label, label);
    page.put("</div></div></div>");
  }
}

void put_pictures(PageWriter& page, const CaseOutcome& outcome) {
  if (outcome.figures.empty()) return put_apart(page, outcome);
  if (outcome.differs) return put_pair(page, outcome);
  CaseOutcome once = outcome;
  once.expected.clear();
  put_apart(page, once);
}

void put_line(PageWriter& page, const std::string& what, const std::string& text) {
  if (!text.empty()) page.put("<p class=\"origin\">" + what + ": " + escaped(text) + "</p>");
}

std::string maker_of(const PictureOrigin& origin) {
  const std::string device = origin_text(origin);
  return device.empty() || origin.program.empty() ? device : device + "; " + origin.program;
}

void put_case(PageWriter& page, const CaseOutcome& outcome) {
  page.put("<details class=\"" + class_of(outcome.verdict) + (is_bad(outcome.verdict) ? "\" open>" : "\">"));
  page.put("<summary><span class=\"word\">" + std::string(word_of(outcome.verdict)) + "</span><span class=\"name\">" +
           escaped(outcome.name) + "</span><span>" + outcome.context + "</span><span class=\"brief\">" +
           fixed(outcome.seconds, 1) + " s</span></summary><div class=\"inside\">");
  if (!outcome.message.empty()) page.put("<p class=\"message\">" + escaped(outcome.message) + "</p>");
  put_figures(page, outcome);
  put_pictures(page, outcome);
  put_line(page, "expected picture by", maker_of(outcome.expected_origin));
  put_line(page, "actual picture by", maker_of(outcome.actual_origin));
  page.put("<p class=\"command\">drawn by <code>" + escaped(outcome.command) + "</code></p></div></details>\n");
}

}  // namespace

Status write_page(const RegressionRun& run, const std::filesystem::path& file) {
  auto created = OutputFile::create(file);
  if (!created) return created.error();
  PageWriter page(*created);
  page.put(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width\"><title>");
  page.put(escaped(run.title) + ": " + summary_of(run) + "</title><style>");
  page.put(page_styles);
  page.put("</style></head><body><header><h1>" + escaped(run.title) + "</h1><p>" + summary_of(run) + ".</p><p>Throng " +
           program_version() + ", commit " + escaped(program_commit()) + "</p></header>\n");
  for (const bool bad : {true, false}) {
    for (const CaseOutcome& outcome : run.outcomes) {
      if (is_bad(outcome.verdict) == bad) put_case(page, outcome);
    }
  }
  page.put("<script>");
  page.put(page_script);
  page.put("</script></body></html>\n");
  return page.outcome() ? created->commit() : page.outcome();
}

}  // namespace throng::app
