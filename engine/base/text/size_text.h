#pragma once

#include <cstdint>
#include <string>

namespace throng {

/// Returns a count of bytes for people: "640 B", "12.3 KiB", "1.5 MiB", "2.3 GiB".
std::string size_text(std::uint64_t bytes);

}  // namespace throng
