#pragma once

#include <cstddef>

#include "throng/render/scenery_data.h"

#include "engine/tracks/ground_plan.h"

namespace throng::app {

/// The height of a plan's walls, in metres: people are seen over them.
inline constexpr float plan_wall_height = 1.2F;
/// The thickness of a plan's walls, in metres.
inline constexpr double plan_wall_thickness = 0.15;

/// This many lines take a second, since each is compared with its neighbours.
inline constexpr std::size_t most_plan_lines = 20'000;

/// Returns how many lines a plan has.
std::size_t plan_lines(const GroundPlan& plan);

/// Returns the mesh of a plan: upright walls, solid obstacles, floors, exits and lines.
/// Walls stand beside the floors, so no agent on a floor stands in one. Where an exit lies there is no wall. Floors lie
/// a few millimetres below the ground, which is drawn behind all else, so that feet and the spots below them stay
/// visible.
/// An outline without an area becomes a wall along its lines. A plan of more than most_plan_lines, or of lines that
/// cross without end, has no mesh.
render::SceneryMeshData plan_mesh(const GroundPlan& plan, float wall_height = plan_wall_height);

}  // namespace throng::app
