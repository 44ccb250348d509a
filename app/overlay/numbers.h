#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace throng::app {

std::string fixed(double value, int decimals);
std::string with_thousands(std::uint64_t value);  ///< 12,345
std::string as_bytes(std::uint64_t bytes);        ///< "640 B", "12.3 KiB", "1.5 MiB"
std::string as_hex(std::uint64_t value);          ///< 16 digits

/// Half of the values are no larger; 0 of none.
float median(std::vector<float> values);

}  // namespace throng::app
