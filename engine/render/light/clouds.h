#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace throng::render {

/// Gives the place on the layer of clouds that a direction above the horizon sees; 1 is about as large as a cloud.
glm::vec2 cloud_place(const glm::vec3& direction);

/// Returns smooth noise, 0 to 1, that has so many ever finer octaves. It is the same on every machine.
float cloud_noise(glm::vec2 place, int octaves);

/// Returns how thick the clouds are where the noise is `noise`, 0 to 1; they cover the share `cover` of the sky.
float cloud_thickness(float noise, float cover);

}  // namespace throng::render
