#include "assets/sheet/contact_sheet.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

namespace throng::sheet {

bool ContactSheet::write(const std::filesystem::path& file) const {
  int width = 1;
  int height = 0;
  for (const render::Image& row : rows_) {
    width = std::max(width, row.width);
    height += row.height;
  }
  render::Image sheet = render::Image::blank(width, height);
  int top = 0;
  for (const render::Image& row : rows_) {
    for (int y = 0; y < row.height; ++y) {
      std::copy_n(row.pixel(0, y), static_cast<std::size_t>(row.width) * 4, sheet.pixel(0, top + y));
    }
    top += row.height;
  }
  for (std::uint8_t& channel : sheet.rgba) channel = static_cast<std::uint8_t>((channel & 0xF8U) | channel >> 5U);
  const auto written = render::write_png(sheet, file);
  if (!written) std::fprintf(stderr, "%s\n", written.error().message.c_str());
  return written.has_value();
}

render::Image beside(const std::vector<render::Image>& pictures) {
  int width = 0;
  int height = 0;
  for (const render::Image& picture : pictures) {
    width += picture.width;
    height = std::max(height, picture.height);
  }
  render::Image row = render::Image::blank(width, height);
  int left = 0;
  for (const render::Image& picture : pictures) {
    for (int y = 0; y < picture.height; ++y) {
      std::copy_n(picture.pixel(0, y), static_cast<std::size_t>(picture.width) * 4, row.pixel(left, y));
    }
    left += picture.width;
  }
  return row;
}

void flatten_background(render::Image& picture, const render::Image& empty) {
  constexpr std::array<std::uint8_t, 4> plain{214, 212, 206, 255};
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    if (std::equal(&picture.rgba[i], &picture.rgba[i] + 3, &empty.rgba[i])) {
      std::ranges::copy(plain, &picture.rgba[i]);
    }
  }
}

}  // namespace throng::sheet
