#include "engine/anim/survey/placement_guess.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/bake/character.h"
#include "engine/anim/rig/limbs.h"
#include "tests/anim/rig/named_skeleton.h"

namespace throng::anim::placement_guess_test {
namespace {

using ::testing::HasSubstr;

/// A box on one bone. `low` and `high` are its corners at rest.
Model box(const glm::vec3& low, const glm::vec3& high) {
  Model model;
  model.skeleton.bones = {{.name = "root", .node = 0, .rest = {}}};
  model.skeleton.references.resize(1);
  model.skeleton.palette.resize(1);
  model.skeleton.level_bone_counts = {1};
  SkinnedMesh& mesh = model.meshes.emplace_back();
  for (int corner = 0; corner < 8; ++corner) {
    mesh.positions.emplace_back((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                                (corner & 4) != 0 ? high.z : low.z);
    mesh.normals.emplace_back(0.0F, 1.0F, 0.0F);
  }
  mesh.palette_entries.assign(8, glm::u16vec4(0));
  mesh.weights.assign(8, glm::vec4(1.0F, 0.0F, 0.0F, 0.0F));
  mesh.indices = {0, 1, 2, 5, 6, 7};
  return model;
}

/// A body of so many units whose feet are at the origin.
Model body(float height) { return box({-height / 6, 0.0F, -height / 8}, {height / 6, height, height / 8}); }

/// Adds a clip that holds the root at `place`.
Model with_clip_at(Model model, const glm::vec3& place) {
  Clip& clip = model.clips.emplace_back(Clip{.name = "held", .duration = 1.0, .tracks = {}});
  clip.tracks.push_back(
      {.bone = 0, .translation = {.times = {0.0F, 1.0F}, .values = {place, place}}, .rotation = {}, .scale = {}});
  return model;
}

CharacterBounds placed_bounds(Model model, const PlacementChoice& choice = {}) {
  place_model(model, guess_placement(model, choice).placement);
  return bake_character(model).bounds;
}

TEST(PlacementGuess, KeepsPeopleRatsAndHouses) {
  for (const float height : {0.2F, 1.1F, 1.7F, 2.4F, 9.0F}) {
    const GuessedPlacement guessed = guess_placement(body(height));
    EXPECT_EQ(guessed.placement, Placement{}) << height;
    EXPECT_TRUE(guessed.is_plain) << height;
  }
}

TEST(PlacementGuess, TakesCentimetresMillimetresAndTinyUnitsAsMetres) {
  for (const float unit : {100.0F, 1000.0F, 0.01F, 1e6F}) {
    const GuessedPlacement guessed = guess_placement(body(1.76F * unit));
    EXPECT_NEAR(guessed.height, 1.76, 1e-3) << unit;
    EXPECT_FALSE(guessed.is_plain) << unit;
    EXPECT_NEAR(placed_bounds(body(1.76F * unit)).height, 1.76, 1e-3) << unit;
  }
  EXPECT_THAT(guess_placement(body(176.0F)).reasons, HasSubstr("1.76 m tall: taken as centimetres (176 units tall"));
  EXPECT_THAT(guess_placement(body(1760.0F)).reasons, HasSubstr("taken as millimetres"));
}

/// An animal, lower than it is long.
Model animal(float length) { return box({-length / 12, 0.0F, -length / 2}, {length / 12, length / 2.5F, length / 2}); }

double side_among_people(const Model& model, const PlacementChoice& choice = {}) {
  const GuessedPlacement guessed = guess_placement(model, choice, SizeRule::among_people);
  EXPECT_EQ(guessed.is_plain, guessed.placement.scale == 1.0 && !choice.scale);
  const double expected = choice.scale.value_or(guessed_scale(*guessed.extent, SizeRule::among_people));
  EXPECT_EQ(guessed.placement.scale, expected);
  const glm::dvec3 size = guessed.placement.scale * guessed.extent->size;
  return std::max({size.x, size.y, size.z});
}

TEST(PlacementGuess, KeepsAmongPeopleWhatFitsThere) {
  for (const float height : {0.3F, 1.1F, 1.8F, 2.9F}) EXPECT_NEAR(side_among_people(body(height)), height, 1e-6);
  for (const float length : {0.4F, 1.5F, 2.4F, 3.9F}) EXPECT_NEAR(side_among_people(animal(length)), length, 1e-6);
}

TEST(PlacementGuess, MakesWhoStandsUprightAndDoesNotFitAsTallAsAPerson) {
  for (const float height : {0.05F, 0.2F, 3.55F, 5.6F, 30.0F}) {
    EXPECT_NEAR(side_among_people(body(height)), tall_person, 1e-6) << height;
    EXPECT_EQ(guess_placement(body(height)).placement, Placement{}) << "only where it is asked for";
  }
  EXPECT_EQ(guess_placement(body(5.6F), {}, SizeRule::among_people).reasons,
            "1.8 m tall: scaled by 0.321 from 5.6 m to fit among people");
}

TEST(PlacementGuess, BringsAnAnimalToTheNearestSizeThatFits) {
  EXPECT_NEAR(side_among_people(animal(0.05F)), least_among_people, 1e-6) << "a mouse";
  EXPECT_NEAR(side_among_people(animal(12.0F)), longest_among_people, 1e-6) << "a dragon";
  EXPECT_NEAR(side_among_people(animal(155.0F)), 1.55, 1e-5) << "a fox in centimetres";
}

TEST(PlacementGuess, TakesAScaleThatIsAskedForAmongPeopleToo) {
  EXPECT_NEAR(side_among_people(body(0.05F), {.scale = 1.0}), 0.05, 1e-6);
  EXPECT_NEAR(side_among_people(body(79.0F), {.scale = 1.0}), 79.0, 1e-4);
}

TEST(PlacementGuess, MovesWhoStandsBesideTheOriginToItsPlace) {
  const GuessedPlacement guessed = guess_placement(box({19.7F, 0.0F, -3.2F}, {20.3F, 1.8F, -2.8F}));
  EXPECT_LT(glm::distance(guessed.placement.offset, glm::dvec3(-20.0, 0.0, 3.0)), 1e-5);
  EXPECT_THAT(guessed.reasons, HasSubstr("moved to its place from 20.2 m beside the file's origin"));
}

TEST(PlacementGuess, LeavesABodyThatIsALittleOffTheOrigin) {
  EXPECT_TRUE(guess_placement(box({-0.2F, 0.0F, -0.3F}, {0.4F, 1.8F, 0.1F})).is_plain);
}

TEST(PlacementGuess, PutsFeetOnTheGroundWhereTheOriginIsAtTheHips) {
  const GuessedPlacement guessed = guess_placement(box({-0.3F, -0.95F, -0.2F}, {0.3F, 0.85F, 0.2F}));
  EXPECT_NEAR(guessed.placement.offset.y, 0.95, 1e-6);
  EXPECT_THAT(guessed.reasons, HasSubstr("raised 0.95 m to stand on the ground"));
}

/// A person whose sword, a vertex of the hand, hangs so far below the ground as the lowest joint is above it.
Model swordsman() {
  Model model;
  model.skeleton = named_skeleton(person_joints());
  SkinnedMesh& mesh = model.meshes.emplace_back();
  const auto add_vertex = [&](int bone, const glm::vec3& position) {
    mesh.positions.push_back(position);
    mesh.normals.emplace_back(0.0F, 1.0F, 0.0F);
    mesh.palette_entries.emplace_back(bone, 0, 0, 0);
    mesh.weights.emplace_back(1.0F, 0.0F, 0.0F, 0.0F);
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.indices.size()));
  };
  for (int bone = 0; bone < model.skeleton.bone_count(); ++bone) {
    const auto joint = glm::vec3(joint_place(model.skeleton, bone).position);
    add_vertex(bone, joint);
    if (find_limbs(model.skeleton).right_arm->end == bone) add_vertex(bone, {joint.x, -0.4F, joint.z});
    if (find_limbs(model.skeleton).left_leg->end == bone) add_vertex(bone, {joint.x, 0.0F, joint.z});
  }
  return model;
}

TEST(PlacementGuess, StandsAPersonOnItsFeetAndNotOnItsSword) {
  const Model model = swordsman();
  EXPECT_NEAR(measure_extent(model)->lowest, 0.0, 1e-6);
  EXPECT_EQ(guess_placement(model).placement.offset.y, 0.0);
}

TEST(PlacementGuess, LeavesSolesALittleBelowAndWhoHoversALittle) {
  EXPECT_TRUE(guess_placement(box({-0.3F, -0.01F, -0.2F}, {0.3F, 1.8F, 0.2F})).is_plain);
  EXPECT_TRUE(guess_placement(box({-0.3F, 0.3F, -0.2F}, {0.3F, 2.1F, 0.2F})).is_plain);
}

TEST(PlacementGuess, MeasuresWhatClipsShowRatherThanTheRestPose) {
  const Model model = with_clip_at(body(1.8F), {5.0F, -0.9F, 0.0F});
  const GuessedPlacement guessed = guess_placement(model);
  EXPECT_LT(glm::distance(guessed.placement.offset, glm::dvec3(-5.0, 0.9, 0.0)), 1e-5);
  EXPECT_LT(placed_bounds(model).reach, 1.2) << "the sphere is around the clip, not around the rest pose";
}

TEST(PlacementGuess, IsThatOfAWalkWhereOneOtherClipReachesBelowTheGround) {
  const Model model = with_clip_at(with_clip_at(body(1.8F), {0.0F, 0.0F, 0.0F}), {0.0F, -0.3F, 0.0F});
  EXPECT_EQ(guess_placement(model).placement.offset.y, 0.0);
}

TEST(PlacementGuess, ObeysAChoice) {
  const Model hips = box({-0.3F, -0.95F, -0.2F}, {0.3F, 0.85F, 0.2F});
  EXPECT_EQ(guess_placement(hips, {.ground = GroundRule::file}).placement, Placement{});
  const Model hovering = box({-0.3F, 0.3F, -0.2F}, {0.3F, 2.1F, 0.2F});
  EXPECT_NEAR(guess_placement(hovering, {.ground = GroundRule::feet}).placement.offset.y, -0.3, 1e-6);
  EXPECT_EQ(guess_placement(body(176.0F), {.scale = 0.5}).placement.scale, 0.5);
  EXPECT_EQ(guess_placement(body(176.0F), {.scale = 1.0}).placement.scale, 1.0);
}

TEST(PlacementGuess, TurnsUprightWhatItsFileHasOnItsBack) {
  const Model lying = box({-0.3F, -0.2F, 0.0F}, {0.3F, 0.2F, 1.8F});
  EXPECT_NEAR(guess_placement(lying).height, 0.4, 1e-6);
  EXPECT_NEAR(guess_placement(lying, {.up = UpAxis::z}).height, 1.8, 1e-6);
  EXPECT_NEAR(placed_bounds(lying, {.up = UpAxis::z}).height, 1.8, 1e-6);
}

TEST(PlacementGuess, SaysThatAModelHasNoExtentAndGivesItTheRoomOfAPerson) {
  Model model = box(glm::vec3(0.0F), glm::vec3(0.0F));
  model.meshes.clear();
  const GuessedPlacement guessed = guess_placement(model);
  EXPECT_EQ(guessed.placement, Placement{});
  EXPECT_THAT(guessed.reasons, HasSubstr("nothing to see"));
  const CharacterBounds bounds = bake_character(model).bounds;
  EXPECT_EQ(bounds.height, tall_person);
  EXPECT_GT(bounds.body_radius, 0.0);
  EXPECT_GT(bounds.reach, 0.0);
}

TEST(CharacterBounds, HoldAWalkInACircleThoughItEndsWhereItBegan) {
  Model model = body(1.8F);
  Clip& clip = model.clips.emplace_back(Clip{.name = "circle", .duration = 4.0, .tracks = {}});
  Track<glm::vec3> track;
  for (int key = 0; key <= 16; ++key) {
    const float angle = static_cast<float>(key) * 0.3927F;
    track.times.push_back(static_cast<float>(key) * 0.25F);
    track.values.emplace_back(3.0F * std::sin(angle), 0.0F, 3.0F - 3.0F * std::cos(angle));
  }
  track.values.back() = track.values.front();
  clip.tracks.push_back({.bone = 0, .translation = track, .rotation = {}, .scale = {}});
  EXPECT_GT(bake_character(model).bounds.reach, 6.0);
}

TEST(CharacterBounds, LeaveOutTheWayThatAClipTravels) {
  Model model = body(1.8F);
  Clip& clip = model.clips.emplace_back(Clip{.name = "straight", .duration = 4.0, .tracks = {}});
  Track<glm::vec3> track{.times = {0.0F, 4.0F}, .values = {{0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 6.0F}}};
  clip.tracks.push_back({.bone = 0, .translation = track, .rotation = {}, .scale = {}});
  EXPECT_LT(bake_character(model).bounds.reach, 2.0);
}

}  // namespace
}  // namespace throng::anim::placement_guess_test
