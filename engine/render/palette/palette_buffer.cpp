#include "engine/render/palette/palette_buffer.h"

#include <algorithm>
#include <cassert>

#include "engine/render/gl/device_errors.h"
#include "engine/render/gl/device_limits.h"

namespace throng::render {
namespace {

constexpr GLbitfield mapping = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;

}  // namespace

PaletteBuffer::PaletteBuffer(std::size_t first_page)
    : first_page_bytes_(first_page),
      block_limit_(std::min(gl::ask_device_limits().storage_block, largest_page_bytes)) {}

PalettePage PaletteBuffer::add_page() {
  if (lent_ < pages_.size()) return pages_[lent_++].memory;
  const std::size_t wanted = pages_.empty() ? first_page_bytes_ : 2 * pages_.back().memory.size;
  const std::size_t size = std::min(wanted, block_limit_);
  gl::Buffer buffer = gl::create_buffer(nullptr, size, mapping);
  void* memory = glMapNamedBufferRange(buffer.id(), 0, static_cast<GLsizeiptr>(size), mapping);
  if (memory == nullptr) {
    // The agents that stay without are told in words; the pictures of the others are whole.
    (void)gl::take_errors("palettes");
    return {};
  }
  pages_.push_back({std::move(buffer), {static_cast<std::byte*>(memory), size}});
  return pages_[lent_++].memory;
}

void PaletteBuffer::take_back_pages() {
  if (pages_.size() > 1) pages_.resize(1);
  lent_ = 0;
}

void PaletteBuffer::bind(std::uint32_t page, GLuint binding) const {
  assert(page < lent_);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, pages_[page].buffer.id());
}

}  // namespace throng::render
