#pragma once

#include <cstdint>
#include <vector>

#include "throng/render/crowd_mesh_data.h"

namespace throng::render {

/// What the bytes of an image are: colours in sRGB, or numbers.
enum class ImageKind : std::uint8_t { colors, numbers };

/// Returns the levels of an image below its first as RGBA: each is half as wide and high as the one before, rounded
/// down, and the last has one pixel. A pixel is the mean of four; that of colours is the mean of their light. The
/// driver makes none, because one that draws on a processor compiles shaders for it, which takes a tenth of a second.
std::vector<std::vector<std::uint8_t>> mip_levels(const ImageData& image, ImageKind kind);

}  // namespace throng::render
