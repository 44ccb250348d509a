#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "throng/render/agent_look.h"
#include "throng/render/crowd_batch.h"
#include "throng/render/instance_record.h"

#include "engine/anim/agent/animation_system.h"
#include "engine/crowd/morph_weights.h"
#include "engine/crowd/system_view.h"

namespace throng {

/// The agents of a picture, and what their records say beside poses.
struct DrawnAgents {
  PlacedAgents agents;
  std::span<const render::Outfit> outfits = {};  ///< [agent]; empty: no agent wears an outfit
  std::uint64_t outfits_number = 0;              ///< another one whenever outfits change; 0: there are none
  std::span<const std::uint16_t> put_away = {};  ///< [place in view] a piece that is not drawn; empty: none is
  std::span<const std::uint32_t> colors = {};    ///< [place in view] InstanceRecord::debug_color; empty: 0
  std::span<const float> contact_scales = {};    ///< [character] InstanceRecord::contact_scale; empty: 1
  bool silhouettes_cast = false;                 ///< silhouettes of agents near by are listed too, for shadows
};

/// Calls visit(piece) for each piece with which the wearer of an outfit is drawn at a mesh LOD: its pieces, or its
/// silhouette far away; without any, all of the character.
void for_each_worn(const render::Outfit& outfit, std::uint32_t mesh_lod, const auto& visit) {
  if (outfit.count == 0) return visit(std::uint32_t{0});
  const bool far = mesh_lod >= render::first_silhouette_lod;
  if (far && outfit.silhouette != render::Outfit::no_piece) return visit(std::uint32_t{outfit.silhouette});
  for (std::size_t i = 0; i < outfit.count; ++i) visit(std::uint32_t{outfit.pieces[i]});
}

/// Sorts the agents in view into runs of the same palette page, character and mesh LOD, so that one instanced draw
/// shows a run. The runs ascend by page, then by character, and the agents within a run. Where agents wear outfits,
/// each piece that an agent of a run wears has a list of its wearers. The PUs of the system do all of it in tiles; the
/// result is the same for any number of them. Memory is kept from frame to frame.
class SortedDraws {
 public:
  /// Sorts the agents. Exact poses are drawn with their full meshes.
  void compose(const SystemView& view, const anim::AnimationSystem& system, const DrawnAgents& drawn,
               Poses poses = Poses::shown);

  std::span<const render::InstanceRecord> instances() const { return std::span(records_).first(instance_count_); }
  std::span<const render::CrowdBatch> batches() const { return wears_outfits() ? lists_ : runs_; }
  /// Returns CrowdFrame::drawn; empty where no agent wears an outfit.
  std::span<const std::uint32_t> drawn() const { return std::span(drawn_).first(drawn_count_); }
  std::span<const render::CrowdBatch> runs() const { return runs_; }
  std::span<const float> morph_weights() const { return std::span(weights_).first(weight_count_); }

 private:
  static constexpr std::size_t most_tiles = 64;
  struct Frame;

  /// Agents whose records one job writes.
  struct Tile {
    std::size_t first = 0, end = 0;  // places in the list of visible agents
    std::uint32_t* runs = nullptr;   // [run] its agents of the tile, and then where the next of them goes
    std::uint32_t* lists = nullptr;  // [run][piece] the same for its wearers; null: no agent wears an outfit
    MorphWeights morphs;             // of its own agents
    std::size_t first_weight = 0;    // where its weights begin among all
  };
  /// Says of a visible agent where its record will be written, and where its weights begin.
  struct Choice {
    std::uint32_t run;      // page, character, mesh LOD
    std::uint32_t weights;  // 1 + the number of the first in the tile, 0: it has none
  };

  bool wears_outfits() const { return pieces_ > 0; }
  void make_room(const DrawnAgents& drawn);
  void look_at_outfits(const DrawnAgents& drawn);
  std::span<Tile> cut_into_tiles(const Frame& frame);
  void choose_runs(const Frame& frame, Tile& tile);
  void begin_runs(const Frame& frame, std::span<Tile> tiles);
  void begin_lists(const Frame& frame, std::span<Tile> tiles);
  void write_records(const Frame& frame, Tile& tile);

  std::vector<Tile> tiles_ = std::vector<Tile>(most_tiles);
  std::vector<Choice> choices_;  // [place in the list of visible agents]
  std::vector<std::uint32_t> run_counts_, list_counts_;
  std::vector<render::InstanceRecord> records_;
  std::size_t instance_count_ = 0;
  std::vector<render::CrowdBatch> runs_, lists_;
  std::vector<std::uint32_t> drawn_;
  std::size_t drawn_count_ = 0;
  std::uint32_t pieces_ = 0;         // that outfits name; 0: no agent wears one
  std::vector<bool> is_silhouette_;  // [piece]
  bool all_have_silhouettes_ = false;
  std::uint64_t outfits_number_ = 0;  // of the outfits to which these belong
  std::vector<float> weights_;
  std::size_t weight_count_ = 0;
};

}  // namespace throng
