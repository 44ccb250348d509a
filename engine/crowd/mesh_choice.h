#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "throng/host.h"

#include "engine/anim/lod/lod.h"
#include "engine/crowd/mesh_lods.h"

namespace throng {

/// Sums up the meshes of all agents in view.
struct MeshFigures {
  std::uint64_t triangles = 0;         ///< as drawn
  std::uint64_t triangles_wanted = 0;  ///< without MeshRules::triangle_budget
  std::uint32_t demoted = 0;           ///< agents whose mesh is coarser than the limit on its error asks for
  float demoted_error_px = 0.0F;       ///< the most that the surface of a demoted agent is off
  bool budget_held = true;             ///< false: all have their coarsest mesh, and triangles exceed the budget
};

/// Chooses the mesh LOD of each agent in view, once a frame: the coarsest within the limit on its error. Where all
/// together exceed MeshRules::triangle_budget, some agents have a coarser one: the steps to coarser meshes that are
/// seen least (MeshLods::seen_px) come first. The result is the same for any number of jobs.
class MeshChoice {
 public:
  /// Makes room for a crowd, so that choose() allocates nothing.
  void reset(std::size_t agents) { lods_.resize(agents); }

  void choose(std::span<const anim::VisibleAgent> visible, std::span<const std::uint8_t> character_of,
              const MeshLods& lods, const MeshRules& rules, Executor& executor, int jobs);

  /// Returns the mesh LODs of the last choice, [place in `visible`].
  std::span<const std::uint8_t> lods() const { return std::span(lods_).first(visible_); }
  const MeshFigures& figures() const { return figures_; }

 private:
  static constexpr std::size_t error_classes = 128;  // eight an octave of pixels
  static constexpr std::size_t most_tiles = 64;
  struct Frame;

  /// Agents that one job chooses for.
  struct Tile {
    std::size_t first = 0, end = 0;
    std::array<std::uint64_t, error_classes> saved;  ///< triangles, by the class of a step's seen pixels
    std::uint64_t to_save = 0;                       ///< triangles, by steps of the last class that is needed
    MeshFigures figures;
  };
  /// Returns the last class whose steps are needed; all steps of lower classes are taken.
  static std::size_t plan_demotions(std::uint64_t to_save, std::span<Tile> tiles);
  void sum_up(std::span<const Tile> tiles);

  std::vector<std::uint8_t> lods_;
  std::size_t visible_ = 0;
  std::vector<Tile> tiles_ = std::vector<Tile>(most_tiles);
  MeshFigures figures_;
};

}  // namespace throng
