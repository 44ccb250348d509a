#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace throng::import {

/// Names the format of a file that is no glTF, and the way to a glTF, as the end of a sentence: "it is an FBX file;
/// ...". The first bytes decide, and the ending of the name where they say nothing. Empty where neither is known.
std::string describe_other_format(std::span<const std::byte> bytes, const std::filesystem::path& path);

}  // namespace throng::import
