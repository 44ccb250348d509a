#pragma once

#include <cstddef>
#include <new>

#include "engine/anim/base/aligned_bytes.h"

namespace throng {

/// Allocates the memory of long vectors that are filled once, in huge pages where the system has them. A first touch of
/// each small page would take a quarter of the time in which a file is read.
template <typename Value>
struct HugePages {
  using value_type = Value;

  HugePages() = default;
  template <typename Other>
  explicit HugePages(const HugePages<Other>&) {}

  Value* allocate(std::size_t count) {
    const std::size_t size = count * sizeof(Value);
    if (size < anim::huge_page_bytes) return static_cast<Value*>(::operator new(size));
    void* const memory = ::operator new (size, std::align_val_t{anim::huge_page_bytes});
    anim::ask_for_huge_pages(static_cast<std::byte*>(memory), size);
    return static_cast<Value*>(memory);
  }
  void deallocate(Value* values, std::size_t count) {
    if (count * sizeof(Value) < anim::huge_page_bytes) return ::operator delete(values);
    ::operator delete (values, std::align_val_t{anim::huge_page_bytes});
  }

  friend bool operator==(const HugePages&, const HugePages&) { return true; }
};

}  // namespace throng
