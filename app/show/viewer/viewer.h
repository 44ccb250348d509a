#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "throng/render/agent_look.h"
#include "throng/render/crowd_draw.h"
#include "throng/render/instance_record.h"

#include "app/show/report/viewer_report.h"
#include "app/show/viewer/turntable.h"
#include "app/show/viewer/viewed_character.h"
#include "engine/crowd/palette_slots.h"

namespace throng::app {

class Stage;

/// Shows one character of a stage alone, at the origin, at a time of its clips that a person sets. It is drawn so large
/// that all its poses fill the same sphere, whatever its size. The stage waits meanwhile; the viewer borrows a palette
/// slot of it and changes nothing else.
class Viewer {
 public:
  /// The stage outlives the viewer, and its characters stay as they are. Errors: there is no such character, agent or
  /// clip; as ViewedCharacter::create().
  /// `meshes` are the character's, as loaded for drawing; none where nothing is drawn.
  static Result<std::unique_ptr<Viewer>> create(const Stage& stage, const ViewRequest& request,
                                                std::vector<ViewedMesh> meshes);
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// Takes a person's choices; choices that the character does not have change nothing.
  void choose(const ViewerSettings& settings);
  const ViewerSettings& settings() const { return settings_; }
  /// Stops at these seconds of the clip.
  void scrub(float seconds);
  /// Goes on by `delta`, and poses the character.
  void advance(Ticks delta);

  Turntable& turntable() { return turntable_; }
  /// Returns the frame to draw from `camera`. It is valid until the viewer changes.
  render::CrowdFrame frame(const render::CameraView& camera);
  ViewerReport report() const;
  const ViewedCharacter& viewed() const { return *viewed_; }
  std::size_t character() const { return character_; }
  const std::optional<RolePreview>& preview() const { return preview_; }

 private:
  Viewer(const Stage& stage, const ViewRequest& request, std::unique_ptr<ViewedCharacter> viewed);
  void dress(const Stage& stage, std::optional<std::uint32_t> agent);
  void pose();
  double length() const;
  bool has_ended() const;
  double seconds_of(int clip) const;
  void add_bounds();
  std::vector<ViewedJoint> joints() const;

  std::size_t character_;
  std::unique_ptr<ViewedCharacter> viewed_;
  PaletteSlots* slots_;
  PaletteSlot slot_;
  std::uint64_t stage_frame_;
  ViewedRoom room_;  // of the character, in its own size
  float scale_;      // at which its sphere has a radius of a metre
  Turntable turntable_;
  ViewerSettings settings_;
  std::optional<RolePreview> preview_;
  std::vector<ViewedMesh> meshes_;
  double seconds_ = 0.0;
  render::CameraView drawn_from_;
  render::InstanceRecord record_{};
  render::AgentLook look_ = render::plain_look();
  std::uint64_t looks_number_ = render::new_looks_number();
  render::CrowdBatch batch_;
  std::vector<float> morph_weights_;
  std::vector<render::SceneLine> lines_;
};

}  // namespace throng::app
