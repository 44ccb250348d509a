#include "app/commands/bench/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>
#include <string_view>

namespace throng::app {
namespace {

constexpr std::array<const char*, 8> colours = {"#2563a8", "#c2541b", "#2f8f5b", "#8a4fa3",
                                                "#b08900", "#11828f", "#b03a5b", "#5b6470"};
constexpr const char* ink = "#20252b";
constexpr const char* faint = "#d8dde3";
constexpr const char* quiet = "#6b747e";

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), value >= 1000 ? "%.0f" : "%.3g", value);
  return text;
}

std::string at(double coordinate) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.1f", coordinate);
  return text;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '&')
      result += "&amp;";
    else if (letter == '<')
      result += "&lt;";
    else
      result += letter;
  }
  return result;
}

/// An SVG file that grows element by element.
class Canvas {
 public:
  Canvas(double width, double height) {
    const std::string size = at(width) + "\" height=\"" + at(height);
    svg_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size + "\" viewBox=\"0 0 " + at(width) + " " +
           at(height) + "\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\">\n<rect width=\"" + size +
           "\" fill=\"#ffffff\"/>\n";
  }
  void text(double x, double y, std::string_view words, const char* colour, const char* anchor = "start",
            const char* more = "") {
    svg_ += "<text x=\"" + at(x) + "\" y=\"" + at(y) + "\" fill=\"" + colour + "\" text-anchor=\"" + anchor + "\"" +
            more + ">" + escaped(words) + "</text>\n";
  }
  void line(double x1, double y1, double x2, double y2, const char* colour) {
    svg_ += "<line x1=\"" + at(x1) + "\" y1=\"" + at(y1) + "\" x2=\"" + at(x2) + "\" y2=\"" + at(y2) + "\" stroke=\"" +
            colour + "\"/>\n";
  }
  void bar(double x, double y, double width, double height, const char* colour) {
    svg_ += "<rect x=\"" + at(x) + "\" y=\"" + at(y) + "\" width=\"" + at(width) + "\" height=\"" + at(height) +
            "\" rx=\"2\" fill=\"" + colour + "\"/>\n";
  }
  void path(const std::string& points, const char* colour, bool dashed) {
    svg_ += "<polyline points=\"" + points + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"2\"" +
            (dashed ? " stroke-dasharray=\"4 4\"" : "") + "/>\n";
  }
  void dot(double x, double y, const char* colour) {
    svg_ += "<circle cx=\"" + at(x) + "\" cy=\"" + at(y) + "\" r=\"3\" fill=\"" + colour + "\"/>\n";
  }
  std::string finish() { return svg_ + "</svg>\n"; }

 private:
  std::string svg_;
};

constexpr const char* bold = " font-size=\"15\" font-weight=\"bold\"";

/// 1, 2 or 5 times a power of ten: about five of them up to `most`.
double tick_step(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most / 5)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (most / (step * power) <= 6) return step * power;
  }
  return 10 * power;
}

/// The area within the axes.
struct Frame {
  double left = 64, top = 48, width = 520, height = 300;
  double least_x = 1, most_x = 2, most_y = 1;
  double least_y = 0;  ///< above 0: the scale is logarithmic

  double x(double value) const {
    const double range = std::log2(most_x / least_x);
    return left + (range > 0 ? std::log2(value / least_x) / range : 0.5) * width;
  }
  double y(double value) const { return top + height - share(value) * height; }
  double share(double value) const {
    return least_y > 0 ? std::log(std::max(value, least_y) / least_y) / std::log(most_y / least_y) : value / most_y;
  }
};

Frame frame_of(const std::vector<PlotLine>& lines, const PlotStyle& style) {
  Frame frame;
  if (!style.note.empty()) frame.top += 18;
  double least_y = 1e300;
  frame.least_x = 1e300;
  frame.most_x = frame.most_y = 1e-300;
  for (const PlotLine& line : lines) {
    for (const double x : line.x) {
      frame.least_x = std::min(frame.least_x, x);
      frame.most_x = std::max(frame.most_x, x);
    }
    for (const double y : line.y) {
      frame.most_y = std::max(frame.most_y, y);
      if (y > 0) least_y = std::min(least_y, y);
    }
  }
  if (style.logarithmic && least_y < frame.most_y) {
    frame.least_y = std::pow(10.0, std::floor(std::log10(least_y)));
    frame.most_y = std::pow(10.0, std::ceil(std::log10(frame.most_y)));
    return frame;
  }
  frame.most_y = std::ceil(frame.most_y / tick_step(frame.most_y)) * tick_step(frame.most_y);
  return frame;
}

std::vector<double> ticks_of(const Frame& frame) {
  std::vector<double> ticks;
  if (frame.least_y > 0) {
    for (double tick = frame.least_y; tick < frame.most_y * 1.001; tick *= 10) ticks.push_back(tick);
    return ticks;
  }
  const double step = tick_step(frame.most_y);
  const auto count = static_cast<int>(frame.most_y * 1.001 / step);
  for (int i = 0; i <= count; ++i) ticks.push_back(i * step);
  return ticks;
}

void draw_axes(Canvas& canvas, const Frame& frame, const std::vector<PlotLine>& lines) {
  for (const double tick : ticks_of(frame)) {
    canvas.line(frame.left, frame.y(tick), frame.left + frame.width, frame.y(tick), faint);
    canvas.text(frame.left - 8, frame.y(tick) + 4, number(tick), quiet, "end");
  }
  std::set<double> places;
  for (const PlotLine& line : lines) places.insert(line.x.begin(), line.x.end());
  constexpr double room_for_a_number = 40;
  double last = -room_for_a_number;
  for (const double place : places) {
    if (frame.x(place) - last < room_for_a_number) continue;
    last = frame.x(place);
    canvas.text(last, frame.top + frame.height + 18, number(place), quiet, "middle");
  }
}

/// Names beside the ends of their lines, pushed apart where they would overlap.
void draw_names(Canvas& canvas, const Frame& frame, const std::vector<PlotLine>& lines) {
  struct Name {
    double y;
    std::size_t line;
  };
  std::vector<Name> names;
  for (std::size_t i = 0; i < lines.size(); ++i) names.push_back({frame.y(lines[i].y.back()) + 4, i});
  std::ranges::sort(names, {}, &Name::y);
  constexpr double line_height = 14;
  double last = 0;
  for (Name& name : names) last = name.y = std::max(name.y, last + line_height);
  double next = frame.top + frame.height + line_height;
  for (auto name = names.rbegin(); name != names.rend(); ++name) next = name->y = std::min(name->y, next - line_height);
  for (const Name& name : names) {
    canvas.text(frame.left + frame.width + 10, name.y, lines[name.line].name, colours[name.line % colours.size()]);
  }
}

}  // namespace

std::string bars_as_svg(const std::string& title, const std::string& unit, const std::vector<PlotBar>& bars) {
  constexpr double left = 190, width = 420, pitch = 30, top = 52, thickness = 18;
  Canvas canvas(left + width + 90, top + pitch * static_cast<double>(bars.size()) + 16);
  canvas.text(24, 30, title, ink, "start", bold);
  double most = 1e-300;
  for (const PlotBar& bar : bars) most = std::max(most, bar.value);
  double y = top;
  for (const PlotBar& bar : bars) {
    const double length = std::max(bar.value / most * width, 1.0);
    canvas.text(left - 10, y + 13, bar.name, ink, "end");
    canvas.bar(left, y, length, thickness, bar.emphasised ? colours[0] : "#a9b8c8");
    canvas.text(left + length + 6, y + 13, number(bar.value) + " " + unit, bar.emphasised ? ink : quiet);
    y += pitch;
  }
  return canvas.finish();
}

std::string lines_as_svg(const std::string& title, const std::string& x_name, const std::string& y_name,
                         const std::vector<PlotLine>& lines, const PlotStyle& style) {
  const Frame frame = frame_of(lines, style);
  Canvas canvas(frame.left + frame.width + 250, frame.top + frame.height + 56);
  canvas.text(24, 26, title, ink, "start", bold);
  if (!style.note.empty()) canvas.text(24, 44, style.note, quiet);
  draw_axes(canvas, frame, lines);
  canvas.text(frame.left, frame.top - 8, y_name, quiet);
  canvas.text(frame.left + frame.width, frame.top + frame.height + 40, x_name, quiet, "end");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const char* const colour = colours[i % colours.size()];
    std::string points;
    for (std::size_t k = 0; k < lines[i].x.size(); ++k) {
      points += at(frame.x(lines[i].x[k])) + "," + at(frame.y(lines[i].y[k])) + " ";
    }
    canvas.path(points, colour, lines[i].dashed);
    if (lines[i].dashed) continue;
    for (std::size_t k = 0; k < lines[i].x.size(); ++k) {
      canvas.dot(frame.x(lines[i].x[k]), frame.y(lines[i].y[k]), colour);
    }
  }
  draw_names(canvas, frame, lines);
  return canvas.finish();
}

}  // namespace throng::app
