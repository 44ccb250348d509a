#include <array>
#include <string>

#include <glm/geometric.hpp>

#include "assets/mannequin/glb.h"
#include "assets/samples/samples.h"

namespace throng::samples {
namespace {

using glm::dvec3;
using mannequin::Region;
using mannequin::Skin;

/// A box between two places, stiff on one joint. Sizes are halves, in metres.
struct Box {
  std::string joint;
  dvec3 from, to;
  double from_width, to_width, depth;
  Region region = Region::untinted;
  dvec3 paint{1};
};

const dvec3 metal(0.62, 0.64, 0.66), dark(0.10, 0.11, 0.13), light(0.25, 0.85, 0.95);

dvec3 at(const std::string& joint) { return mannequin::skeleton()[mannequin::joint_index(joint)].position; }

std::vector<Box> trunk() {
  const dvec3 eyes = at("head") + dvec3(0, 0.13, 0);
  return {
      {"hips", {0, 0.86, 0}, {0, 0.99, 0}, 0.11, 0.15, 0.09, Region::trousers},
      {"spine", {0, 0.99, -0.01}, {0, 1.17, -0.01}, 0.08, 0.09, 0.06, Region::untinted, dark},
      {"upper_chest", {0, 1.17, -0.01}, {0, 1.45, -0.01}, 0.14, 0.20, 0.12, Region::shirt},
      {"upper_chest", {0, 1.22, -0.14}, {0, 1.42, -0.14}, 0.11, 0.11, 0.05, Region::untinted, metal},
      {"neck", {0, 1.45, -0.02}, {0, 1.58, -0.01}, 0.045, 0.045, 0.045, Region::untinted, dark},
      {"head", {0, 1.57, 0}, {0, 1.79, 0}, 0.10, 0.12, 0.11, Region::shirt},
      {"head", eyes + dvec3(0, -0.035, 0.11), eyes + dvec3(0, 0.035, 0.11), 0.085, 0.085, 0.012, Region::untinted,
       light},
      {"head", {0.09, 1.79, 0}, {0.09, 1.90, 0}, 0.008, 0.008, 0.008, Region::untinted, metal},
  };
}

/// Returns the boxes of the left arm and leg.
std::vector<Box> limbs() {
  const dvec3 shoulder = at("upper_arm.L"), elbow = at("forearm.L"), wrist = at("hand.L");
  const dvec3 hip = at("thigh.L"), knee = at("shin.L"), ankle = at("foot.L"), toe = at("toe.L");
  const dvec3 along = glm::normalize(wrist - elbow);
  return {
      {"upper_arm.L", shoulder - along * 0.05, shoulder + along * 0.09, 0.075, 0.07, 0.075, Region::shirt},
      {"upper_arm.L", shoulder + along * 0.09, elbow, 0.04, 0.04, 0.04, Region::untinted, dark},
      {"forearm.L", elbow - along * 0.02, wrist, 0.045, 0.06, 0.055, Region::untinted, metal},
      {"hand.L", wrist, wrist + along * 0.13, 0.04, 0.03, 0.045, Region::untinted, dark},
      {"thigh.L", hip, knee + dvec3(0, 0.05, 0), 0.075, 0.06, 0.075, Region::trousers},
      {"shin.L", knee + dvec3(0, 0.07, 0), ankle + dvec3(0, 0.03, 0), 0.05, 0.07, 0.065, Region::untinted, metal},
      {"foot.L", {ankle.x, 0.06, ankle.z - 0.06}, {toe.x, 0.05, toe.z}, 0.05, 0.055, 0.05, Region::untinted, dark},
      {"toe.L", {toe.x, 0.035, toe.z}, {toe.x, 0.03, toe.z + 0.08}, 0.055, 0.045, 0.03, Region::untinted, dark},
  };
}

Box mirrored(Box box) {
  box.joint = mannequin::skeleton()[mannequin::mirrored_joint(mannequin::joint_index(box.joint))].name;
  box.from.x = -box.from.x;
  box.to.x = -box.to.x;
  return box;
}

std::vector<Box> all_boxes() {
  std::vector<Box> boxes = trunk();
  for (const Box& limb : limbs()) {
    boxes.push_back(limb);
    boxes.push_back(mirrored(limb));
  }
  return boxes;
}

/// Adds the side of a box that looks along an axis, or against it, as four points of its own.
void add_side(Skin& skin, const Box& box, const std::array<dvec3, 3>& axes, std::size_t axis, bool against) {
  mannequin::SkinFace face{.corners = {}, .region = box.region, .paint = std::vector<dvec3>(4, box.paint)};
  constexpr std::array<std::array<double, 2>, 4> around{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (std::size_t corner = 0; corner < 4; ++corner) {
    std::array<double, 3> signs{};
    signs[axis] = against ? -1 : 1;
    signs[(axis + 1) % 3] = around[against ? 3 - corner : corner][0];
    signs[(axis + 2) % 3] = around[against ? 3 - corner : corner][1];
    const bool is_end = signs[2] > 0;
    const dvec3 place = (is_end ? box.to : box.from) + axes[0] * signs[0] * (is_end ? box.to_width : box.from_width) +
                        axes[1] * signs[1] * box.depth;
    face.corners.push_back(skin.points.size());
    skin.points.push_back({.position = place, .weights = mannequin::bind({{box.joint, 1.0}})});
  }
  skin.faces.push_back(std::move(face));
}

void add(Skin& skin, const Box& box) {
  const dvec3 along = glm::normalize(box.to - box.from);
  const dvec3 ahead = along.z > 0.7 ? dvec3(0, -1, 0) : dvec3(0, 0, 1);
  const dvec3 aside = glm::normalize(glm::cross(ahead, along));
  const std::array<dvec3, 3> axes{aside, glm::cross(along, aside), along};  // right-handed
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const bool against : {false, true}) add_side(skin, box, axes, axis, against);
  }
}

/// Returns whether a joint moves a box, itself or by a joint below it.
std::array<bool, mannequin::joint_count> joints_in_use(const std::vector<Box>& boxes) {
  std::array<bool, mannequin::joint_count> used{};
  for (const Box& box : boxes) used[mannequin::joint_index(box.joint)] = true;
  for (std::size_t j = mannequin::joint_count; j-- > 1;) {
    if (used[j]) used[mannequin::skeleton()[j].parent] = true;
  }
  return used;
}

/// Returns the clips without the joints that move nothing, such as fingers: they are most of a file.
std::vector<mannequin::Clip> clips_of(const std::vector<Box>& boxes) {
  const auto used = joints_in_use(boxes);
  std::vector<mannequin::Clip> clips;
  for (const auto& motion :
       {mannequin::make_idle(), mannequin::make_walk(), mannequin::make_jog(), mannequin::make_wave()}) {
    clips.push_back(mannequin::sample(motion));
    for (mannequin::Pose& pose : clips.back().keys) {
      for (std::size_t j = 0; j < used.size(); ++j) {
        if (!used[j]) pose.rotations[j] = glm::dquat(1, 0, 0, 0);
      }
    }
  }
  return clips;
}

}  // namespace

std::vector<std::byte> make_robot() {
  const std::vector<Box> boxes = all_boxes();
  Skin skin;
  for (const Box& box : boxes) add(skin, box);
  mannequin::compute_normals(skin);
  return mannequin::write_glb(mannequin::make_mesh(skin), clips_of(boxes), "robot");
}

}  // namespace throng::samples
