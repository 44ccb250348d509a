#pragma once

#include "throng/camera.h"
#include "throng/crowd.h"
#include "throng/heading.h"
#include "throng/math.h"
#include "throng/pose_request.h"
#include "throng/render/agent_look.h"
#include "throng/render/crowd_batch.h"
#include "throng/render/instance_record.h"
#include "throng/render/mesh_error_value.h"
#include "throng/render/palette_page.h"
#include "throng/result.h"
#include "throng/standard.h"
#include "throng/ticks.h"
#include "throng/view_rules.h"

namespace throng {

/// How a crowd is seen in a frame. The spans have an element for each agent, by its number; dead numbers' elements are
/// not read.
struct ViewFrame {
  std::span<const Vec3> positions{};    ///< metres, world, between the feet
  std::span<const Heading> headings{};  ///< empty: all face +Z
  std::span<const float> scales{};      ///< empty: all 1
  Camera camera{};                      ///< decides who is in view; see include_casters
  Mat4 view{}, projection{};            ///< of the picture; identities: no error is measured
  float width = 1280.0F;                ///< of the picture, pixels
  float height = 720.0F;
  ViewRules rules{};
  Ticks frame_step{};  ///< the time since the frame before; 0: time stands still
  std::uint64_t completed =
      0;  ///< the newest CrowdView::frame() that the device has finished reading: memory of palettes
          ///< that were shown up to then is written again. It rises, or memory grows without end
};

/// What agents wear. A character's mesh has pieces; an agent is drawn with the pieces of its outfit.
struct WornOutfits {
  std::span<const render::Outfit> outfits{};  ///< by the agent's number; empty: no agent wears an outfit
  std::uint64_t number = 0;                   ///< another one whenever outfits change; 0: there are none
  bool silhouettes_cast = false;              ///< silhouettes of agents near by are listed too, for shadows
};

/// The agents in view, sorted into runs that one instanced draw each can show. Runs ascend by page, then by character.
struct CrowdDraws {
  std::span<const render::InstanceRecord> instances{};  ///< for the device, in the order of the runs
  std::span<const render::CrowdBatch> batches{};        ///< one instanced draw each
  std::span<const std::uint32_t> drawn{};  ///< with outfits, the instances of each batch; empty: batches are runs
  std::span<const render::CrowdBatch> runs{};
  std::span<const float> morph_weights{};  ///< InstanceRecord::weights
  std::uint32_t now = 0;                   ///< the time of InstanceRecord::blend_start
};

/// What a view shows, and what it costs the eye. Pixels are of the picture, over the last 60 frames.
struct ViewFigures {
  std::uint32_t agents_in_view = 0;
  std::uint32_t agents_posed = 0;  ///< of the last frame
  std::uint64_t triangles = 0;     ///< of the agents in view; 0: no mesh LODs were set
  float error_p50 = 0.0F;          ///< error of poses and meshes together, of the agents that were measured
  float error_p99 = 0.0F;
  float error_max = 0.0F;
  std::uint32_t error_samples = 0;
  bool out_of_memory = false;  ///< an agent is not drawn, since the page source gave no more
};

/// Shows a crowd: level of detail chooses the agents that are posed, slots in pages take their palettes, skipped poses
/// are blended on the screen, each agent gets a mesh LOD, and the error of what is shown is measured. It draws nothing,
/// so any renderer can. One thread calls it. In a frame:
///
///     crowd.advance(step)
///     view.choose(crowd, frame)       lists the agents that are due; a host may set their PoseRequest::joints
///     view.pose(crowd)                the PUs write their palettes into pages
///     view.draws(crowd)               instances and batches for the device
///
/// A vertex shader finds the palettes of an instance by its record (throng/render/instance_record.h). The memory of a
/// palette is written again once no frame after ViewFrame::completed reads it. Nothing is allocated in a frame but when
/// agents or characters are added. A call of a view that was moved from is a misuse (host.h).
class CrowdView {
 public:
  /// Asks `pages`, which outlives the view, for memory, at first in the first pose().
  explicit CrowdView(render::PalettePageSource& pages);
  ~CrowdView();
  CrowdView(CrowdView&&) noexcept;
  CrowdView& operator=(CrowdView&&) noexcept;

  /// Sets the meshes of a character, as long as the crowd has it. Without them all its agents have mesh LOD 0. Errors:
  /// the spans differ in length, or have none or more than 7 elements.
  Result<Done> set_mesh_lods(CharacterId character, const render::MeshLodList& meshes);

  /// Chooses what is seen, and lists the agents to be posed. The span is valid until the next call.
  std::span<PoseRequest> choose(Crowd& crowd, const ViewFrame& frame);
  /// Poses the agents that choose() listed, with palettes for those in view, and measures errors.
  void pose(Crowd& crowd);
  /// Sorts the agents in view. The spans are valid until the next call.
  CrowdDraws draws(const Crowd& crowd, const WornOutfits& worn = {});

  /// Makes an agent due in the next frame, as a request for a clip does by itself: after another request that must be
  /// seen at once.
  void make_due(AgentId agent);
  /// Returns whether the agent was in view in the last choice.
  bool is_visible(AgentId agent) const;
  /// Returns the number of the frame that was chosen last, from 1.
  std::uint64_t frame() const;
  ViewFigures figures() const;

 private:
  struct State;
  bool is_gone(const char* call) const;
  void take_characters(const Crowd& crowd);

  std::unique_ptr<State> state_;
};

}  // namespace throng
