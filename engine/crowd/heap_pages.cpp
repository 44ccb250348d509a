#include "throng/heap_pages.h"

namespace throng {

render::PalettePage HeapPageSource::add_page() {
  pages_.push_back(std::make_unique_for_overwrite<Line[]>((page_bytes_ + sizeof(Line) - 1) / sizeof(Line)));
  return {pages_.back()[0].bytes, page_bytes_};
}

}  // namespace throng
