#pragma once

#include <filesystem>

namespace throng::app::test {

/// Writes a character of twelve spheres, each of another material, into a folder, and returns its file. From the top
/// left: plaster, lacquer, gold, metal and rubber in a texture; bumps, occlusion, lamps, holes; glass, unlit, colours
/// of vertices, specular and glossy.
std::filesystem::path write_material_spheres(const std::filesystem::path& folder);

}  // namespace throng::app::test
