#include "engine/crowd/palette_slots.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <span>
#include <utility>

namespace throng {
namespace {

std::uint32_t whole_lines(std::size_t bytes) {
  return static_cast<std::uint32_t>((bytes + render::palette_line_bytes - 1) / render::palette_line_bytes);
}

constexpr std::uint32_t bits_a_word = 64;
constexpr std::uint64_t bit_of(std::uint32_t line) { return std::uint64_t{1} << (line % bits_a_word); }

/// Finds the smallest of the descending sizes that is large enough.
std::uint32_t next_size(std::span<const std::uint32_t> sizes, std::uint32_t lines) {
  const auto smaller = std::ranges::find_if(sizes, [lines](std::uint32_t size) { return size < lines; });
  assert(smaller != sizes.begin() && "more lines than any slot was announced to have");
  return *(smaller - 1);
}

}  // namespace

PaletteSlots::PaletteSlots(render::PalettePageSource& source, const std::vector<std::size_t>& sizes)
    : source_(&source) {
  assert(!sizes.empty());
  for (const std::size_t bytes : sizes) sizes_.push_back(whole_lines(bytes));
  std::ranges::sort(sizes_, std::greater<>());
  sizes_.erase(std::unique(sizes_.begin(), sizes_.end()), sizes_.end());
}

PaletteSlot PaletteSlots::acquire(std::size_t bytes, std::uint32_t near) {
  const std::uint32_t lines = next_size(sizes_, whole_lines(bytes));
  if (near != PaletteSlot::none) return take(near, lines);
  for (std::uint32_t page = 0; page < pages_.size(); ++page) {
    if (!has_room_for_newcomer(pages_[page])) continue;
    if (const PaletteSlot slot = take(page, lines); slot.valid()) return slot;
  }
  if (add_page()) return take(static_cast<std::uint32_t>(pages_.size() - 1), lines);
  for (std::uint32_t page = 0; page < pages_.size(); ++page) {
    if (const PaletteSlot slot = take(page, lines); slot.valid()) return slot;
  }
  return {};
}

bool PaletteSlots::has_room_for_newcomer(const Page& page) const {
  return page.lines_in_use * render::palette_line_bytes < page.memory.size / 3;
}

bool PaletteSlots::add_page() {
  const render::PalettePage memory = source_->add_page();
  if (memory.memory == nullptr) return false;
  Page page;
  page.memory = memory;
  const std::size_t lines = memory.size / render::palette_line_bytes;
  page.free_by_size.resize(sizes_.size());
  // Reserves as many as the page has room for, so that no frame allocates. Memory that is never used is never touched.
  for (std::size_t i = 0; i < sizes_.size(); ++i) page.free_by_size[i].reserve(lines / sizes_[i]);
  retired_.reserve(retired_.capacity() + lines / sizes_.back());
  page.acquired.resize(lines / bits_a_word + 1);
  pages_.push_back(std::move(page));
  return true;
}

PaletteSlot PaletteSlots::take(std::uint32_t page, std::uint32_t lines) {
  Page& from = pages_[page];
  PaletteSlot slot{page, 0, lines};
  if ((from.next_line + lines) * render::palette_line_bytes <= from.memory.size &&
      from.free_by_size[size_index(lines)].empty()) {
    slot.first_line = from.next_line;
    from.next_line += lines;
  } else {
    // Sizes descend, so this goes from the smallest slot that is large enough to larger ones.
    std::size_t size = size_index(lines);
    while (from.free_by_size[size].empty()) {
      if (size == 0) return {};
      --size;
    }
    slot.lines = sizes_[size];
    slot.first_line = from.free_by_size[size].back();
    from.free_by_size[size].pop_back();
  }
  from.acquired[slot.first_line / bits_a_word] |= bit_of(slot.first_line);
  from.lines_in_use += slot.lines;
  ++in_use_;
  bytes_in_use_ += slot.lines * render::palette_line_bytes;
  return slot;
}

void PaletteSlots::retire(const PaletteSlot& slot, std::uint64_t last_frame) {
  assert(is_acquired(slot));
  pages_[slot.page].acquired[slot.first_line / bits_a_word] &= ~bit_of(slot.first_line);
  retired_.push_back({slot, last_frame});
}

void PaletteSlots::reclaim(std::uint64_t completed_frame) {
  const auto is_free = [&](const Retired& retired) { return retired.last_frame <= completed_frame; };
  for (const Retired& retired : retired_) {
    if (!is_free(retired)) continue;
    const PaletteSlot& slot = retired.slot;
    Page& page = pages_[slot.page];
    page.free_by_size[size_index(slot.lines)].push_back(slot.first_line);
    page.lines_in_use -= slot.lines;
    --in_use_;
    bytes_in_use_ -= slot.lines * render::palette_line_bytes;
  }
  std::erase_if(retired_, is_free);
}

std::size_t PaletteSlots::size_index(std::uint32_t lines) const {
  const auto found = std::ranges::find(sizes_, lines);
  assert(found != sizes_.end());
  return static_cast<std::size_t>(found - sizes_.begin());
}

bool PaletteSlots::is_acquired(const PaletteSlot& slot) const {
  if (!slot.valid() || slot.page >= pages_.size()) return false;
  return (pages_[slot.page].acquired[slot.first_line / bits_a_word] & bit_of(slot.first_line)) != 0;
}

std::byte* PaletteSlots::memory(const PaletteSlot& slot) const {
  assert(is_acquired(slot));
  return pages_[slot.page].memory.memory + slot.first_line * render::palette_line_bytes;
}

}  // namespace throng
