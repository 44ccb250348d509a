#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "throng/render/agent_look.h"
#include "throng/render/context.h"
#include "throng/render/image.h"
#include "throng/render/renderer.h"

#include "app/character/source.h"
#include "app/people/crowd/character_look.h"
#include "app/people/wardrobe/clothing.h"
#include "assets/mannequin/pose.h"
#include "engine/anim/base/transform.h"
#include "engine/crowd/palette_slots.h"

namespace throng::sheet {

/// One person in a picture.
struct Figure {
  std::string clip = {};                               ///< empty: the bind pose, or `pose`
  double seconds = 0;                                  ///< of the clip
  std::optional<mannequin::Pose> pose = std::nullopt;  ///< instead of a clip
  std::vector<anim::PaletteMatrix> palette = {};       ///< instead of either
  glm::vec3 place{0.0F};                               ///< metres
  float heading = 0.0F;                                ///< radians, 0 faces the camera
  float scale = 1.0F;
  std::size_t mesh_lod = 0;
  std::uint32_t bone_level = 0;
  app::Tints tints{};
  app::Variant variant{};
  std::optional<render::AgentLook> look = std::nullopt;  ///< instead of tints and variant
  render::Outfit outfit = {};                            ///< of the wardrobe; empty: the character's own clothes
};

/// Where a picture is taken from and how large it is. The camera stands far off, so that nothing is foreshortened.
struct Shot {
  int width = 0;
  int height = 0;
  float metres = 2.0F;  ///< from the lower to the upper edge
  glm::vec3 centre{0.0F};
  float pitch = -0.08F;  ///< radians, negative looks down
  float yaw = 0.0F;
  bool shadows = true;
};

/// Draws figures as the demo does, on the software device, before a plain ground.
class Studio {
 public:
  /// Null, and a sentence on stderr, where something is missing.
  static std::unique_ptr<Studio> open(bool with_wardrobe = false);

  render::Image take(const Shot& shot, const std::vector<Figure>& figures);
  const app::CharacterSource& character() const { return character_; }
  const app::Clothing& clothing() const { return clothing_; }
  std::size_t mesh_lod_count() const { return renderer_->mesh_lods(0).errors.size(); }

 private:
  Studio() = default;
  std::vector<anim::PaletteMatrix> palette_of(const Figure& figure) const;
  render::InstanceRecord record_of(const Figure& figure);

  app::CharacterSource character_;
  app::Clothing clothing_;
  std::unique_ptr<render::gl::Context> context_;
  std::unique_ptr<render::Renderer> renderer_;
  std::unique_ptr<PaletteSlots> slots_;
};

}  // namespace throng::sheet
