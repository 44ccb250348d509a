// Labels against the picture, the crowd and the poses that they are of.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "app/output/label_frame.h"
#include "app/show/opened_show.h"
#include "app/show/painter.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "engine/anim/asset/skeleton.h"
#include "tests/gl/small_picture.h"

namespace throng::app::labels_test {
namespace {

using render::LabelPicture;
using render::PixelBox;

constexpr int width = 480, height = 320, agents = 50;

/// Fifty people in view, posed exactly, with the labels of a frame.
class LabelledCrowd {
 public:
  explicit LabelledCrowd(int longest_tile = 4096) {
    DemoOptions options = picture_by_processor(width, height);
    options.tuning = without_level_of_detail(Tuning());
    options.tuning.agents = agents;
    options.tuning.shadows = options.tuning.crowd_shade = false;
    options.tuning.wardrobe = false;     // a run of instances is drawn as it is
    options.tuning.placed_feet = false;  // or exact poses are not known to the other way of asking for them
    options.msaa = 0;
    options.longest_tile = longest_tile;
    options.output.labels = "labels";  // nothing is written there
    StartError error;
    show_ = open_show(options, error);
    EXPECT_NE(show_, nullptr) << error.message;
    for (int frame = 0; frame < 20; ++frame) show_->animate(ticks_per_second / 60);
    maker_ = std::make_unique<LabelMaker>(show_->stage());
    const Status made = maker_->make(*show_, 1, false);
    EXPECT_TRUE(made) << made.error().message;
  }

  Show& show() { return *show_; }
  const Stage& stage() const { return show_->stage(); }
  const LabelPicture& picture() const { return maker_->picture(); }
  const LabelFrame& frame() const { return maker_->frame(); }
  render::Renderer& renderer() { return show_->painter().renderer(); }

  /// A frame of the crowd as it was drawn, in a light that computes the same wherever it is drawn.
  render::CrowdFrame crowd_frame() const {
    const Picture& picture = show_->painter().picture();
    return {.camera = render::view_of(show_->view().camera, static_cast<float>(width) / height),
            .instances = picture.instances(),
            .batches = picture.batches(),
            .now = stage().now(),
            .shadows = false,
            .crowd_shade = false,
            .looks = stage().crowd().looks().drawn,
            .looks_number = stage().crowd().looks().number};
  }

 private:
  std::unique_ptr<Show> show_;
  std::unique_ptr<LabelMaker> maker_;
};

/// Tests look at one crowd, whose context is current all the while.
class LabelsOfFifty : public testing::Test {
 protected:
  static void SetUpTestSuite() { crowd_ = std::make_unique<LabelledCrowd>(); }
  static void TearDownTestSuite() { crowd_.reset(); }
  static LabelledCrowd& crowd_of_fifty() { return *crowd_; }

 private:
  static std::unique_ptr<LabelledCrowd> crowd_;
};
std::unique_ptr<LabelledCrowd> LabelsOfFifty::crowd_;

/// The box and the number of the pixels that have a label.
struct Pixels {
  PixelBox box;
  std::uint64_t count = 0;
};

Pixels pixels_of(const LabelPicture& picture, std::uint32_t label) {
  Pixels pixels;
  for (int y = 0; y < picture.size.y; ++y) {
    for (int x = 0; x < picture.size.x; ++x) {
      if (picture.agents[picture.place(x, y)] != label) continue;
      if (pixels.count++ == 0) pixels.box = {x, y, x + 1, y + 1};
      pixels.box = {std::min(pixels.box.left, x), std::min(pixels.box.top, y), std::max(pixels.box.right, x + 1),
                    std::max(pixels.box.bottom, y + 1)};
    }
  }
  return pixels;
}

/// Counts the visible joints that a camera puts outside of the box of their person, grown by a pixel.
int joints_outside(const LabelFrame& frame, const LabelCamera& camera) {
  int outside = 0;
  for (const LabelledPerson& person : frame.people) {
    for (const LabelPoint& joint : person.joints) {
      if (joint.seen != Seen::visible) continue;
      const glm::vec3 seen = camera.project(joint.place);
      const PixelBox& box = person.box;
      const bool is_inside = seen.z > 0.0F && seen.x >= static_cast<float>(box.left - 1) &&
                             seen.x <= static_cast<float>(box.right + 1) && seen.y >= static_cast<float>(box.top - 1) &&
                             seen.y <= static_cast<float>(box.bottom + 1);
      if (!is_inside) ++outside;
    }
  }
  return outside;
}

TEST_F(LabelsOfFifty, HaveABoxOfEachThatIsThatOfItsPixels) {
  LabelledCrowd& crowd = crowd_of_fifty();
  std::size_t seen = 0;
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    const Pixels pixels = pixels_of(crowd.picture(), agent + 1);
    const auto& people = crowd.frame().people;
    const auto person = std::ranges::find(people, agent, &LabelledPerson::agent);
    ASSERT_EQ(person != people.end(), pixels.count > 0) << agent;
    if (pixels.count == 0) continue;
    ++seen;
    EXPECT_EQ(person->box, pixels.box) << agent;
  }
  EXPECT_EQ(seen, crowd.frame().people.size());
  EXPECT_GT(seen, 25U);
}

TEST_F(LabelsOfFifty, PutEachVisibleJointIntoItsBox) {
  LabelledCrowd& crowd = crowd_of_fifty();
  EXPECT_EQ(joints_outside(crowd.frame(), crowd.frame().camera), 0);
  std::ptrdiff_t visible = 0;
  for (const LabelledPerson& person : crowd.frame().people) {
    visible += std::ranges::count(person.joints, Seen::visible, &LabelPoint::seen);
    for (const LabelPoint& joint : person.joints) {
      const glm::vec3 seen = crowd.frame().camera.project(joint.place);
      if (joint.seen == Seen::not_in_picture) continue;
      EXPECT_LT(glm::distance(glm::vec2(seen), joint.pixel), 0.01F);
    }
  }
  EXPECT_GT(visible, 300);
}

TEST_F(LabelsOfFifty, ShowAWrongCamera) {
  LabelledCrowd& crowd = crowd_of_fifty();
  LabelCamera moved = crowd.frame().camera, turned = moved, zoomed = moved, mirrored = moved;
  moved.to_camera[3].x += 0.25F;
  turned.to_camera = glm::transpose(turned.to_camera);
  zoomed.focal *= 1.1F;
  mirrored.focal.y *= -1.0F;
  for (const LabelCamera& wrong : {moved, turned, zoomed, mirrored})
    EXPECT_GT(joints_outside(crowd.frame(), wrong), 20);
}

TEST_F(LabelsOfFifty, NameTheAgentsWhereTheyAre) {
  LabelledCrowd& crowd = crowd_of_fifty();
  for (const LabelledPerson& person : crowd.frame().people) {
    EXPECT_EQ(person.id, std::to_string(person.agent));
    EXPECT_EQ(person.position, crowd.stage().crowd().positions()[person.agent]);
    const Heading heading = crowd.stage().crowd().headings()[person.agent];
    EXPECT_NEAR(std::sin(person.heading), heading.sine, 1e-5);
    EXPECT_NEAR(std::cos(person.heading), heading.cosine, 1e-5);
    EXPECT_FALSE(person.role.empty());
    EXPECT_FALSE(person.clip.empty());
  }
}

// Poses are asked for in another way: as palettes, whose entries carry the joints of the bind pose.
TEST_F(LabelsOfFifty, HaveTheJointsOfThePose) {
  LabelledCrowd& crowd = crowd_of_fifty();
  const anim::Skeleton& skeleton = crowd.stage().characters().front().character->skeleton;
  std::vector<anim::PaletteMatrix> palette(static_cast<std::size_t>(skeleton.palette_count()));
  for (const LabelledPerson& person : crowd.frame().people) {
    ASSERT_TRUE(crowd.stage().system().agent(person.agent).can_pose_exactly());
    const anim::ExactPose asked{.agent = {person.agent}, .palette = palette.data()};
    auto& system = const_cast<anim::AnimationSystem&>(crowd.stage().system());  // to ask changes nothing
    system.pose_exactly({&asked, 1});
    const Heading heading = crowd.stage().crowd().headings()[person.agent];
    const float scale = crowd.stage().crowd().scales()[person.agent];
    for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
      const anim::JointPlace place = anim::joint_place(skeleton, bone);
      if (place.entry < 0) continue;
      const auto& rows = palette[static_cast<std::size_t>(place.entry)].rows;
      glm::vec3 own;
      for (int axis = 0; axis < 3; ++axis) {
        own[axis] =
            static_cast<float>(glm::dot(glm::dvec3(rows[axis][0], rows[axis][1], rows[axis][2]), place.position) +
                               static_cast<double>(rows[axis][3]));
      }
      const glm::vec3 turned(heading.cosine * own.x + heading.sine * own.z, own.y,
                             heading.cosine * own.z - heading.sine * own.x);
      const glm::vec3 expected = person.position + scale * turned;
      EXPECT_LT(glm::distance(person.joints[static_cast<std::size_t>(bone)].place, expected), 0.001F)
          << person.agent << ' ' << skeleton.bones[static_cast<std::size_t>(bone)].name;
    }
  }
}

// The crowd is drawn in colour, and once more without it: pixels differ where somebody is.
TEST_F(LabelsOfFifty, AreWhereThePictureHasSomebody) {
  LabelledCrowd& crowd = crowd_of_fifty();
  LabelPicture labels;
  render::CrowdFrame frame = crowd.crowd_frame();
  crowd.renderer().draw(frame);
  const render::Image with = crowd.renderer().read_image();
  ASSERT_TRUE(crowd.renderer().draw_labels(frame, labels));
  frame.batches = {};
  crowd.renderer().draw(frame);
  const render::Image without = crowd.renderer().read_image();
  int nobody = 0, alike = 0;
  for (std::size_t pixel = 0; pixel < labels.agents.size(); ++pixel) {
    const bool differs = !std::equal(&with.rgba[4 * pixel], &with.rgba[4 * pixel] + 3, &without.rgba[4 * pixel]);
    if (differs && labels.agents[pixel] == 0) ++nobody;
    if (!differs && labels.agents[pixel] != 0) ++alike;
  }
  EXPECT_EQ(nobody, 0);
  EXPECT_LT(alike, 20);  // somebody may have the colour of what is behind
}

TEST_F(LabelsOfFifty, HaveSharesThatAgreeWithDrawingEachAlone) {
  LabelledCrowd& crowd = crowd_of_fifty();
  const auto instances = crowd.show().painter().picture().instances();
  int hidden = 0;
  for (const LabelledPerson& person : crowd.frame().people) {
    render::CrowdFrame frame = crowd.crowd_frame();
    const auto instance = static_cast<std::uint32_t>(
        std::ranges::find(instances, person.agent, &render::InstanceRecord::agent) - instances.begin());
    render::CrowdBatch batch = *std::ranges::find_if(frame.batches, [&](const render::CrowdBatch& each) {
      return instance >= each.first && instance < each.first + each.count;
    });
    batch.first = instance;
    batch.count = 1;
    frame.batches = {&batch, 1};
    LabelPicture alone;
    crowd.renderer().upload(frame);
    ASSERT_TRUE(crowd.renderer().draw_labels(frame, alone));
    const Pixels whole = pixels_of(alone, person.agent + 1), seen = pixels_of(crowd.picture(), person.agent + 1);
    ASSERT_GT(whole.count, 0U);
    const double share = static_cast<double>(seen.count) / static_cast<double>(whole.count);
    EXPECT_NEAR(person.share_visible, share, std::max(0.005, 2.0 / static_cast<double>(whole.count))) << person.agent;
    EXPECT_LE(std::abs(person.whole_box.left - whole.box.left), 1) << person.agent;
    EXPECT_LE(std::abs(person.whole_box.top - whole.box.top), 1) << person.agent;
    EXPECT_LE(std::abs(person.whole_box.right - whole.box.right), 1) << person.agent;
    EXPECT_LE(std::abs(person.whole_box.bottom - whole.box.bottom), 1) << person.agent;
    if (share < 0.9) ++hidden;
  }
  EXPECT_GT(hidden, 5);
}

// At a visible joint its own body is seen, a little before it. At a hidden one, whoever hides it is nearer. A hand
// beside its outline may have anything behind it.
TEST_F(LabelsOfFifty, HaveDepthsInTheOrderOfJoints) {
  LabelledCrowd& crowd = crowd_of_fifty();
  const LabelPicture& picture = crowd.picture();
  int visible = 0, on_surface = 0, behind_others = 0, others_nearer = 0;
  for (const LabelledPerson& person : crowd.frame().people) {
    for (const LabelPoint& joint : person.joints) {
      if (joint.seen == Seen::not_in_picture) continue;
      const float metres = crowd.frame().camera.project(joint.place).z;
      const std::size_t at = picture.place(static_cast<int>(joint.pixel.x), static_cast<int>(joint.pixel.y));
      const std::uint32_t label = picture.agents[at];
      if (joint.seen == Seen::visible) {
        ++visible;
        EXPECT_GT(picture.metres[at], metres - 0.35F) << person.agent;
        if (label == person.agent + 1 && picture.metres[at] < metres + 0.05F) ++on_surface;
      } else if (label != 0 && label != person.agent + 1) {
        ++behind_others;
        if (picture.metres[at] < metres) ++others_nearer;
      }
    }
  }
  EXPECT_GT(on_surface, visible * 9 / 10);
  EXPECT_GT(behind_others, 50);
  EXPECT_GT(others_nearer, behind_others * 9 / 10);
}

TEST_F(LabelsOfFifty, HaveTheGroundWhereFeetStand) {
  LabelledCrowd& crowd = crowd_of_fifty();
  const LabelPicture& picture = crowd.picture();
  int looked_at = 0;
  for (const LabelledPerson& person : crowd.frame().people) {
    const glm::vec3 beside = person.position + glm::vec3(0.5F, 0.0F, 0.5F);
    const glm::vec3 seen = crowd.frame().camera.project(beside);
    if (seen.x < 0 || seen.y < 0 || seen.x >= width || seen.y >= height) continue;
    const float metres = picture.metres[picture.place(static_cast<int>(seen.x), static_cast<int>(seen.y))];
    EXPECT_LT(metres, seen.z * 1.02F);
    if (metres > seen.z * 0.98F) ++looked_at;
  }
  EXPECT_GT(looked_at, 10);
}

TEST(LabelsInTiles, AreThoseOfTheWholePicture) {
  const auto labels_of = [](int longest_tile) {
    const LabelledCrowd crowd(longest_tile);
    return std::pair(crowd.picture().agents, crowd.frame().people.size());
  };
  const auto whole = labels_of(4096), parts = labels_of(128);
  ASSERT_EQ(whole.first.size(), parts.first.size());
  std::size_t others = 0;
  for (std::size_t i = 0; i < whole.first.size(); ++i) others += whole.first[i] != parts.first[i] ? 1U : 0U;
  EXPECT_LE(others, whole.first.size() / 2000);
  EXPECT_EQ(whole.second, parts.second);
}

}  // namespace
}  // namespace throng::app::labels_test
