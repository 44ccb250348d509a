// golden_sheet BEFORE_FOLDER AFTER_FOLDER OUT.png: every picture that changed, before on the left, after on the right.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "throng/render/image.h"

namespace {

using throng::render::Image;
namespace fs = std::filesystem;

struct Row {
  Image before, after;
};

Image read_or_blank(const fs::path& file, const Image& like) {
  auto image = throng::render::read_png(file);
  return image ? *image : Image::blank(like.width, like.height);
}

std::vector<Row> changed_pictures(const fs::path& before, const fs::path& after) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(after)) files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<Row> rows;
  for (const fs::path& file : files) {
    auto picture = throng::render::read_png(file);
    if (!picture) continue;
    Row row{read_or_blank(before / file.filename(), *picture), *picture};
    if (row.before.rgba != row.after.rgba) rows.push_back(std::move(row));
  }
  return rows;
}

void paste(Image& sheet, const Image& picture, int left, int top) {
  for (int y = 0; y < picture.height; ++y) {
    std::copy_n(picture.pixel(0, y), static_cast<std::size_t>(picture.width) * 4, sheet.pixel(left, top + y));
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 4) {
    std::fputs("usage: golden_sheet BEFORE_FOLDER AFTER_FOLDER OUT.png\n", stderr);
    return 2;
  }
  const std::vector<Row> rows = changed_pictures(arguments[1], arguments[2]);
  int width = 1;
  int height = 1;
  for (const Row& row : rows) {
    width = std::max(width, row.after.width);
    height += row.after.height;
  }
  Image sheet = Image::blank(2 * width, height);
  int top = 0;
  for (const Row& row : rows) {
    paste(sheet, row.before, 0, top);
    paste(sheet, row.after, width, top);
    top += row.after.height;
  }
  const auto written = throng::render::write_png(sheet, arguments[3]);
  if (!written) std::fprintf(stderr, "%s\n", written.error().message.c_str());
  return written ? 0 : 1;
}
