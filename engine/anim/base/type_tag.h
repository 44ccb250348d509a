#pragma once

#include <cstdint>

namespace throng::anim {

/// Tells types apart without run-time type information, which a host may have switched off. It is the hash of the
/// type's name, so it is the same in every module of a program.
using TypeTag = std::uint64_t;

template <typename Type>
constexpr TypeTag type_tag() {
#if defined(_MSC_VER) && !defined(__clang__)
  const char* name = __FUNCSIG__;
#else
  const char* name = __PRETTY_FUNCTION__;
#endif
  TypeTag tag = 0xCBF29CE484222325U;  // FNV-1a
  for (; *name != '\0'; ++name) tag = (tag ^ static_cast<unsigned char>(*name)) * 0x100000001B3U;
  return tag;
}

}  // namespace throng::anim
