#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "throng/render/camera.h"
#include "throng/render/instance_record.h"
#include "throng/render/label_picture.h"

#include "app/output/coco.h"
#include "app/show/show.h"

namespace throng::app {

/// Says whether a point of a body is seen, by COCO's numbers.
enum class Seen : std::uint8_t { not_in_picture, hidden, visible };

/// A joint or another point of a body.
struct LabelPoint {
  glm::vec3 place{0.0F};  ///< metres, world space
  glm::vec2 pixel{0.0F};  ///< from the top left corner of the picture; 0, 0 behind the camera
  Seen seen = Seen::not_in_picture;
};

/// A person with at least one visible pixel.
struct LabelledPerson {
  std::uint32_t agent = 0;
  std::string id;
  std::size_t character = 0;
  std::string role, clip;
  render::PixelBox box;                            ///< of the visible pixels
  render::PixelBox whole_box;                      ///< of all pixels that the picture would show of it alone
  double share_visible = 0;                        ///< visible pixels over all of them
  glm::vec3 position{0.0F};                        ///< metres, between the feet
  float heading = 0.0F;                            ///< radians about +Y; 0 faces +Z, a quarter turn +X
  std::vector<LabelPoint> joints;                  ///< [bone]
  std::array<LabelPoint, coco_names.size()> coco;  ///< as far as the character has them
};

/// Says how the camera takes a picture: x to the right, y down, z ahead.
struct LabelCamera {
  glm::mat4 to_camera{1.0F};            ///< from the world
  glm::vec2 focal{1.0F}, middle{0.0F};  ///< pixels

  explicit LabelCamera(const render::CameraView& view, glm::ivec2 size);
  LabelCamera() = default;
  /// Returns the pixel of a point of the world and, as z, its distance along the axis; above 0 ahead of the camera.
  glm::vec3 project(const glm::vec3& place) const;
};

/// The labels of a frame.
struct LabelFrame {
  int number = 0;
  double seconds = 0;
  std::optional<double> file_seconds;  ///< of the clock of the file that the crowd is from
  glm::ivec2 size{0};
  LabelCamera camera;
  double metres_a_step = 0.001;  ///< of the depth picture
  std::vector<LabelledPerson> people;
};

/// Returns the name by which labels know an agent: its name in the file that it is from, or its number.
std::string id_of_agent(const Stage& stage, std::uint32_t agent);

/// Makes the labels of the frame that a show animated last. Keeps its memory from frame to frame.
class LabelMaker {
 public:
  /// Finds the points of all characters of a stage.
  explicit LabelMaker(const Stage& stage);

  /// Errors: as draw_labels() and Painter::measure_bodies().
  Status make(Show& show, int number, bool is_drawn);
  const render::LabelPicture& picture() const { return picture_; }
  LabelFrame& frame() { return frame_; }
  const std::vector<CocoPoints>& coco() const { return coco_; }

 private:
  /// The visible pixels of an agent.
  struct SeenPart {
    render::PixelBox box;
    std::uint64_t pixels = 0;
  };

  void find_seen_parts(std::size_t agents);
  void bound_bodies(const Show& show);
  void add_people(const Show& show);
  LabelledPerson person(const Stage& stage, const render::InstanceRecord& record, const render::BodyAlone& body) const;
  static void add_boxes(const SeenPart& seen, const render::BodyAlone& body, LabelledPerson& person);
  void add_points(const Stage& stage, const render::InstanceRecord& record, LabelledPerson& person) const;
  LabelPoint point(const render::InstanceRecord& record, const glm::vec3& place, float height) const;
  bool is_in_picture(glm::ivec2 pixel) const;
  bool is_visible(std::uint32_t label, glm::ivec2 pixel, float metres, float height) const;
  void choose_scale();

  std::vector<CocoPoints> coco_;  // [character]
  render::LabelPicture picture_;
  std::vector<SeenPart> seen_;             // [agent]
  std::vector<render::PixelBox> boxes_;    // [instance]
  std::vector<render::BodyAlone> bodies_;  // [instance]
  LabelFrame frame_;
};

}  // namespace throng::app
