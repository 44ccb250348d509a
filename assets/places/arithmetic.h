#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace throng::places {

inline constexpr double pi = 3.14159265358979323846;

/// Sine and cosine of an angle in turns, of additions and multiplications alone: those of a machine's own library may
/// differ in the last bit, and the file must be the same everywhere.
double sine(double turns);
double cosine(double turns);

/// Returns a number from 0 to 1 that looks like chance and is the same every time.
double chance(std::uint32_t seed, std::uint32_t index);

/// Returns the linear colour of an sRGB colour as designers write it, 0xRRGGBB.
glm::dvec3 rgb(std::uint32_t hex);

}  // namespace throng::places
