#include "app/output/regression/compare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

#include "app/settings/option_values.h"

namespace throng::app {
namespace {

using render::Image;
using render::NumberImage;

constexpr int colour_channels = 3;
constexpr int block_edge = 16;
constexpr const char *kind_keyword = "Throng holds", *step_keyword = "Throng depth_step";

std::string sides_of(const NumberImage& image) {
  return std::to_string(image.width) + "x" + std::to_string(image.height);
}

/// Returns the contents that two pictures share. Grey pictures that do not name their contents may hold anything.
std::optional<PixelKind> kind_of_both(PixelKind expected, PixelKind actual) {
  if (expected == actual) return expected;
  if (expected != PixelKind::numbers && actual != PixelKind::numbers) return {};
  const bool has_colours = expected == PixelKind::colours || actual == PixelKind::colours;
  return has_colours ? PixelKind::colours : PixelKind::numbers;
}

/// Says how far one pixel is off: all channels together, and the worst of them in steps of 255, rounded up.
struct PixelDifference {
  double sum = 0.0;
  int worst = 0;
  bool is_seen = false;
};

/// Finds how far pixels of two pictures of equal contents are off.
class PixelMeter {
 public:
  PixelMeter(const ComparedPicture& expected, const ComparedPicture& actual, PixelKind kind)
      : expected_(expected), actual_(actual), kind_(kind) {}

  int channels() const { return kind_ == PixelKind::colours ? colour_channels : 1; }
  PixelDifference at(int x, int y) const {
    if (kind_ == PixelKind::colours) return colours_at(x, y);
    const int before = value(expected_, x, y, 0), now = value(actual_, x, y, 0);
    if (kind_ == PixelKind::depths) return between_depths(before, now);
    return before == now ? PixelDifference() : PixelDifference{.sum = 1.0, .worst = 255, .is_seen = true};
  }
  int steps_at(int x, int y, int channel) const {
    return std::abs(value(expected_, x, y, channel) - value(actual_, x, y, channel));
  }

 private:
  static int value(const ComparedPicture& picture, int x, int y, int channel) {
    const std::uint16_t* const pixel = picture.image.pixel(x, y);
    if (picture.image.channels > 1) return pixel[channel];
    return channel == colour_channels ? 65535 : pixel[0];
  }

  PixelDifference colours_at(int x, int y) const {
    int sum = 0, worst = 0;
    for (int channel = 0; channel < colour_channels; ++channel) {
      const int steps = steps_at(x, y, channel);
      sum += steps;
      worst = std::max(worst, steps);
    }
    const int alpha = steps_at(x, y, colour_channels);
    sum = std::max(sum, alpha * colour_channels);
    worst = std::max(worst, alpha);
    return {.sum = static_cast<double>(sum) / render::deep_steps,
            .worst = (worst + render::deep_steps - 1) / render::deep_steps,
            .is_seen = worst > seen_steps * render::deep_steps};
  }

  /// Pictures of two steps round one depth differently, by half of the coarser step at most.
  PixelDifference between_depths(int before, int now) const {
    const auto metres = [](const ComparedPicture& picture, int depth) {
      return picture.metres_a_step * (depth == 0 ? 65535 : depth);
    };
    const double off = std::abs(metres(expected_, before) - metres(actual_, now));
    const double rounding = std::max(expected_.metres_a_step, actual_.metres_a_step) / 2;
    if (off <= rounding && (before == 0) == (now == 0)) return {};
    return {.sum = off, .worst = 255, .is_seen = true};
  }

  const ComparedPicture &expected_, &actual_;
  PixelKind kind_;
};

/// Pictures of one size are painted whatever their contents.
PixelMeter painting_meter(const ComparedPicture& expected, const ComparedPicture& actual) {
  return {expected, actual, kind_of_both(expected.kind, actual.kind).value_or(PixelKind::colours)};
}

void paint(std::uint8_t* pixel, const std::array<int, 3>& color) {
  for (std::size_t channel = 0; channel < color.size(); ++channel) {
    pixel[channel] = static_cast<std::uint8_t>(std::clamp(color[channel], 0, 255));
  }
}

/// Between two stops the colour is mixed. A single step has to be seen on grey already.
std::array<int, 3> heat_of(int steps) {
  struct Stop {
    int steps;
    std::array<int, 3> color;
  };
  static constexpr std::array<Stop, 4> stops{
      {{1, {60, 90, 220}}, {16, {40, 200, 210}}, {32, {250, 220, 40}}, {64, {230, 30, 30}}}};
  if (steps >= stops.back().steps) return stops.back().color;
  std::size_t next = 1;
  while (stops.at(next).steps < steps) ++next;
  const Stop &from = stops.at(next - 1), &to = stops.at(next);
  std::array<int, 3> color{};
  for (std::size_t i = 0; i < color.size(); ++i) {
    color.at(i) =
        from.color.at(i) + (to.color.at(i) - from.color.at(i)) * (steps - from.steps) / (to.steps - from.steps);
  }
  return color;
}

int dimmed_grey(const std::uint8_t* pixel) { return 40 + (pixel[0] * 2 + pixel[1] * 5 + pixel[2]) / 20; }

/// A ring of white around one of magenta is seen on any picture.
void frame_block(Image& picture, int left, int top) {
  constexpr std::array<int, 3> magenta{255, 0, 255}, white{255, 255, 255};
  for (int away = 1; away <= 3; ++away) {
    const int edge = block_edge + 2 * away - 1;  // between two sides of the ring
    for (int i = 0; i <= edge; ++i) {
      const int x = left - away, y = top - away;
      for (const auto& [px, py] :
           {std::pair{x + i, y}, std::pair{x + i, y + edge}, std::pair{x, y + i}, std::pair{x + edge, y + i}}) {
        if (px < 0 || py < 0 || px >= picture.width || py >= picture.height) continue;
        paint(picture.pixel(px, py), away == 3 ? white : magenta);
      }
    }
  }
}

}  // namespace

std::string pixel_kind_name(PixelKind kind) {
  constexpr std::array<const char*, 4> names{"colours", "numbers", "labels", "depths"};
  return names.at(static_cast<std::size_t>(kind));
}

Result<ComparedPicture> read_compared(const std::filesystem::path& file) {
  auto image = render::read_any_png(file);
  if (!image) return image.error();
  const PixelKind value_if_omitted = image->channels == 1 ? PixelKind::numbers : PixelKind::colours;
  ComparedPicture picture(std::move(*image), value_if_omitted);
  const auto texts = render::read_png_texts(file);
  if (!texts || value_if_omitted == PixelKind::colours) return picture;
  for (const render::PngText& each : *texts) {
    if (each == label_texts().front()) picture.kind = PixelKind::labels;
    if (each.keyword != step_keyword) continue;
    const auto step = finite_number_in(each.text);
    if (step && *step > 0.0) picture.metres_a_step = *step;
  }
  if (picture.metres_a_step > 0.0) picture.kind = PixelKind::depths;
  return picture;
}

std::vector<render::PngText> label_texts() { return {{kind_keyword, pixel_kind_name(PixelKind::labels)}}; }

std::vector<render::PngText> depth_texts(double metres_a_step) {
  return {{kind_keyword, pixel_kind_name(PixelKind::depths)}, {step_keyword, shortest_text(metres_a_step)}};
}

Result<PictureDifference> measure_difference(const ComparedPicture& expected, const ComparedPicture& actual) {
  const NumberImage& picture = expected.image;
  if (picture.width != actual.image.width || picture.height != actual.image.height) {
    return Error{"the sizes differ: " + sides_of(picture) + " expected, " + sides_of(actual.image) + " drawn"};
  }
  const auto kind = kind_of_both(expected.kind, actual.kind);
  if (!kind) {
    return Error{"what the pictures hold differs: " + pixel_kind_name(expected.kind) + " expected, " +
                 pixel_kind_name(actual.kind) + " drawn; compare two of one kind"};
  }
  const PixelMeter meter(expected, actual, *kind);
  PictureDifference result{.kind = *kind};
  double total = 0.0, seen = 0.0;
  for (int top = 0; top < picture.height; top += block_edge) {
    for (int left = 0; left < picture.width; left += block_edge) {
      const int bottom = std::min(top + block_edge, picture.height);
      const int right = std::min(left + block_edge, picture.width);
      double sum = 0.0;
      for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x) {
          const PixelDifference pixel = meter.at(x, y);
          sum += pixel.sum;
          seen += pixel.is_seen ? 1 : 0;
        }
      }
      total += sum;
      const double block_mean = sum / static_cast<double>((bottom - top) * (right - left) * meter.channels());
      if (block_mean <= result.worst_block) continue;
      result.worst_block = block_mean;
      result.worst_block_x = left;
      result.worst_block_y = top;
    }
  }
  const double pixels = static_cast<double>(picture.width) * picture.height;
  result.mean = total / (pixels * meter.channels());
  result.share = seen / pixels;
  return result;
}

Image paint_difference(const ComparedPicture& expected, const ComparedPicture& actual) {
  constexpr int gain = 8;
  const PixelMeter meter = painting_meter(expected, actual);
  Image picture = Image::blank(expected.image.width, expected.image.height);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const int alpha = meter.steps_at(x, y, colour_channels);
      std::array<int, 3> color{};
      for (int channel = 0; channel < colour_channels; ++channel) {
        const int steps = std::max(meter.steps_at(x, y, channel), alpha);
        color.at(static_cast<std::size_t>(channel)) = (gain * steps + render::deep_steps - 1) / render::deep_steps;
      }
      if (meter.channels() == 1) color.fill(meter.at(x, y).worst);
      paint(picture.pixel(x, y), color);
    }
  }
  return picture;
}

Image paint_heat(const ComparedPicture& expected, const ComparedPicture& actual, const PictureDifference& difference) {
  const PixelMeter meter = painting_meter(expected, actual);
  Image picture = render::in_8_bits(expected.image);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const int steps = meter.at(x, y).worst;
      const int grey = dimmed_grey(picture.pixel(x, y));
      paint(picture.pixel(x, y), steps == 0 ? std::array<int, 3>{grey, grey, grey} : heat_of(steps));
      picture.pixel(x, y)[colour_channels] = 255;
    }
  }
  if (difference.worst_block > 0) frame_block(picture, difference.worst_block_x, difference.worst_block_y);
  return picture;
}

Image rounded_to_bits(Image image, int bits) {
  const auto kept = static_cast<std::uint8_t>(0xFFU << static_cast<unsigned>(8 - bits));
  for (std::uint8_t& value : image.rgba) {
    if (value != 255) value = static_cast<std::uint8_t>(value & kept);
  }
  return image;
}

ComparedPicture rounded_to_bits(ComparedPicture picture, int bits) {
  if (bits == 8 || picture.kind != PixelKind::colours) return picture;
  return rounded_to_bits(render::in_8_bits(picture.image), bits);
}

}  // namespace throng::app
