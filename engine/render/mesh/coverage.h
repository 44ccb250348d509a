#pragma once

#include "throng/render/crowd_mesh_data.h"

namespace throng::render {

/// Says how much of a surface its alpha shows.
enum class Coverage : unsigned char {
  opaque,   ///< all of it
  cut_out,  ///< where its alpha reaches the cutoff
  blended   ///< as much of it as its alpha says
};

/// Returns how a material's alpha must be drawn. Many files call materials blended or cut out whose alpha
/// is 1 everywhere; such materials are opaque, which is drawn fastest.
Coverage coverage_of(const CrowdMeshData& data, int material);

}  // namespace throng::render
