#include "app/people/place/place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "app/people/crowd/crowd.h"
#include "app/people/crowd/plaza_plan.h"
#include "app/people/place/props.h"
#include "app/show/camera/scenes.h"
#include "tests/app/people/crowd/crowd_person.h"

namespace throng::app::place_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;
constexpr std::array scenes{Scene::plaza, Scene::parade, Scene::stadium, Scene::film};
constexpr std::array<std::size_t, 7> sizes{1, 10, 100, 300, 1000, 10'000, 100'000};

std::string case_of(Scene scene, std::size_t agents) {
  return "scene " + std::to_string(static_cast<int>(scene)) + " of " + std::to_string(agents);
}

struct Box {
  glm::vec3 lowest{std::numeric_limits<float>::max()}, highest{std::numeric_limits<float>::lowest()};
};

/// [prop] the box around its mesh.
const std::vector<Box>& boxes() {
  static const std::vector<Box> all = [] {
    const auto props = read_props(THRONG_SOURCE_DIR "/assets/places.glb");
    std::vector<Box> made(prop_count);
    EXPECT_TRUE(props) << (props ? "" : props.error().message);
    for (std::size_t prop = 0; props && prop < prop_count; ++prop) {
      const auto mesh = std::ranges::find(*props, prop_names[prop], &render::SceneryMeshData::name);
      EXPECT_NE(mesh, props->end()) << prop_names[prop];
      if (mesh == props->end()) continue;
      for (const render::SceneryVertex& vertex : mesh->vertices) {
        const glm::vec3 at(vertex.position[0], vertex.position[1], vertex.position[2]);
        made[prop].lowest = glm::min(made[prop].lowest, at);
        made[prop].highest = glm::max(made[prop].highest, at);
      }
    }
    return made;
  }();
  return all;
}

/// A prop with the way from the world into it.
struct Standing {
  explicit Standing(const PlacedProp& placed)
      : prop(placed.prop),
        box(boxes()[static_cast<std::size_t>(placed.prop)]),
        into(glm::inverse(glm::mat4(placed.place))) {}

  bool holds(const glm::vec3& point, float margin) const {
    const glm::vec3 at(into * glm::vec4(point, 1.0F));
    return glm::all(glm::greaterThan(at, box.lowest - margin)) && glm::all(glm::lessThan(at, box.highest + margin));
  }
  bool is_between(const glm::vec3& from, const glm::vec3& to) const {
    const glm::vec3 start(into * glm::vec4(from, 1.0F)), way = glm::vec3(into * glm::vec4(to, 1.0F)) - start;
    const glm::vec3 a = (box.lowest - start) / way, b = (box.highest - start) / way;
    const glm::vec3 first = glm::min(a, b), last = glm::max(a, b);
    return std::max({first.x, first.y, first.z, 0.0F}) < std::min({last.x, last.y, last.z, 1.0F});
  }

  Prop prop;
  Box box;
  glm::mat4 into;
};

bool is_house(Prop prop) {
  return prop == Prop::arcade_bay || prop == Prop::arcade_corner || prop == Prop::facade_a || prop == Prop::facade_b ||
         prop == Prop::facade_c || prop == Prop::facade_d || prop == Prop::facade_e || prop == Prop::facade_corner ||
         prop == Prop::tower;
}

std::vector<Standing> standing(const Surroundings& place, const auto& is_wanted) {
  std::vector<Standing> found;
  for (const PlacedProp& placed : place.props) {
    if (is_wanted(placed.prop)) found.emplace_back(placed);
  }
  return found;
}

/// The film has a thing in the air beside its people.
std::vector<CharacterRoles> cast_of(Scene scene) {
  std::vector<CharacterRoles> cast{person()};
  if (scene != Scene::film) return cast;
  cast.push_back(person());
  cast.back().is_prop = true;
  return cast;
}

TEST(Places, GridIsBare) {
  EXPECT_TRUE(surroundings_of(Scene::grid, 1000, 1, person()).props.empty());
  EXPECT_EQ(surroundings_of(Scene::grid, 1000, 1, person()).ground, render::SceneGround{});
}

TEST(Places, AreTheSameForTheSameArguments) {
  for (const Scene scene : scenes) {
    const Surroundings place = surroundings_of(scene, 300, 7, person()),
                       again = surroundings_of(scene, 300, 7, person());
    ASSERT_EQ(place.props.size(), again.props.size());
    ASSERT_GT(place.props.size(), 50U);
    for (std::size_t i = 0; i < place.props.size(); ++i) {
      EXPECT_EQ(place.props[i].prop, again.props[i].prop);
      EXPECT_EQ(place.props[i].place, again.props[i].place);
      EXPECT_EQ(place.props[i].tint, again.props[i].tint);
    }
  }
}

TEST(Places, GrowWithTheCharacter) {
  CharacterRoles giant = person();
  giant.height = 18.0;
  giant.walk_speed *= 10.0;
  for (const Scene scene : scenes) {
    const Surroundings place = surroundings_of(scene, 300, 1, person()), larger = surroundings_of(scene, 300, 1, giant);
    ASSERT_EQ(place.props.size(), larger.props.size()) << case_of(scene, 300);
    for (std::size_t i = 0; i < place.props.size(); ++i) {
      for (int column = 0; column < 4; ++column) {
        EXPECT_LT(glm::distance(place.props[i].place[column] * 10.0F, larger.props[i].place[column]), 0.2F);
      }
    }
  }
}

void expect_cameras_outside(Scene scene, std::size_t agents, Clothes clothes) {
  const auto props = standing(surroundings_of(scene, agents, 1, person(), clothes), [](Prop) { return true; });
  for (const NamedCamera& camera : scene_cameras(scene, agents, person(), clothes)) {
    const glm::vec3 eye(camera.place.x, camera.place.y, camera.place.z);
    for (const Standing& prop : props) {
      EXPECT_FALSE(prop.holds(eye, 0.2F))
          << case_of(scene, agents) << ", " << camera.name << " in " << name_of(prop.prop);
    }
  }
}

TEST(Places, CamerasAreOutsideOfEverything) {
  for (const std::size_t agents : sizes) {
    for (const Scene scene : scenes) expect_cameras_outside(scene, agents, Clothes::own);
    expect_cameras_outside(Scene::plaza, agents, Clothes::pattern);
  }
}

TEST(Places, HousesHideHardlyAnybodyFromACamera) {
  for (const Scene scene : scenes) {
    for (const std::size_t agents : {10U, 300U, 1000U, 10'000U}) {
      const auto houses = standing(surroundings_of(scene, agents, 1, person()), is_house);
      const Crowd crowd(scene, agents, 1, cast_of(scene));
      for (const NamedCamera& camera : scene_cameras(scene, agents, person())) {
        const glm::vec3 eye(camera.place.x, camera.place.y, camera.place.z);
        int hidden = 0, looked_at = 0;
        for (std::size_t agent = 0; agent < crowd.size(); agent += 1 + crowd.size() / 200) {
          const glm::vec3 head = crowd.positions()[agent] + glm::vec3(0.0F, 1.6F, 0.0F);
          ++looked_at;
          hidden += std::ranges::any_of(houses, [&](const Standing& house) { return house.is_between(eye, head); });
        }
        EXPECT_LE(hidden, looked_at / 20) << case_of(scene, agents) << ", " << camera.name;
      }
    }
  }
}

TEST(Places, NobodyStandsInAnythingInAnyFrameOfAMinute) {
  // People sit on these, walk below them, or stand on them.
  const auto is_solid = [](Prop prop) {
    constexpr std::array others{Prop::tree_a,   Prop::tree_b, Prop::tree_c,     Prop::lamp,  Prop::flag,
                                Prop::bunting,  Prop::seat,   Prop::seat_block, Prop::kiosk, Prop::roof_bay,
                                Prop::fountain, Prop::statue, Prop::planter,    Prop::bench, Prop::goal};
    return std::ranges::find(others, prop) == others.end();
  };
  for (const Scene scene : scenes) {
    for (const std::size_t agents : {10U, 300U, 1000U}) {
      const auto props = standing(surroundings_of(scene, agents, 1, person()), is_solid);
      Crowd crowd(scene, agents, 1, cast_of(scene));
      for (int second = 0; second < 60; ++second) {
        for (int i = 0; i < 6; ++i) crowd.advance(10 * frame);
        for (const glm::vec3& feet : crowd.positions()) {
          for (const Standing& prop : props) {
            ASSERT_FALSE(prop.holds(feet + glm::vec3(0.0F, 0.5F, 0.0F), 0.0F))
                << case_of(scene, agents) << ", in " << name_of(prop.prop) << " at " << feet.x << ", " << feet.z;
          }
        }
      }
    }
  }
}

TEST(Places, TiersAreBelowEverySeat) {
  for (const std::size_t agents : {10U, 300U, 1000U, 5000U}) {
    const Surroundings place = surroundings_of(Scene::stadium, agents, 1, person());
    const auto blocks = standing(place, [](Prop prop) { return prop == Prop::seat_block; });
    const auto seats = standing(place, [](Prop prop) { return prop == Prop::seat; });
    const Crowd crowd(Scene::stadium, agents, 1, person());
    for (std::size_t agent = crowd.walkers().count(); agent < crowd.size(); ++agent) {
      const glm::vec3 feet = crowd.positions()[agent];
      const Heading heading = crowd.headings()[agent];
      const glm::vec3 seat = feet - 0.39F * glm::vec3(heading.sine, 0.0F, heading.cosine);
      if (feet.y > 0.0F) {
        for (const glm::vec3& trodden : {feet, seat}) {
          EXPECT_TRUE(std::ranges::any_of(blocks,
                                          [&](const Standing& block) {
                                            const glm::vec3 below = trodden - glm::vec3(0.0F, 0.01F, 0.0F),
                                                            above = trodden + glm::vec3(0.0F, 0.01F, 0.0F);
                                            return block.holds(below, 1e-4F) && !block.holds(above, 1e-4F);
                                          }))
              << agents << ", seat " << agent;
        }
      }
      EXPECT_EQ(std::ranges::count_if(seats,
                                      [&](const Standing& each) {
                                        const glm::vec3 at(each.into * glm::vec4(seat, 1.0F));
                                        return glm::length(at) < 0.05F;
                                      }),
                1)
          << agents << ", seat " << agent;
    }
  }
}

TEST(PlazaFixtures, DoNotMeetEachOtherNorHouses) {
  for (const std::size_t agents : {10U, 100U, 300U, 1000U, 10'000U}) {
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
      const std::vector<Fixture> fixtures = plan_plaza(agents, seed, person()).fixtures;
      const double edge = plaza_edge(agents, 1.0);
      for (std::size_t i = 0; i < fixtures.size(); ++i) {
        const Fixture& here = fixtures[i];
        const double reach = std::max(std::abs(here.position.x), std::abs(here.position.y)) + radius_of(here.kind);
        EXPECT_LT(reach, edge - 0.3) << agents << ", fixture " << i;
        for (std::size_t other = i + 1; other < fixtures.size(); ++other) {
          const double apart = glm::distance(here.position, fixtures[other].position);
          EXPECT_GT(apart, radius_of(here.kind) + radius_of(fixtures[other].kind))
              << agents << ": " << i << ", " << other;
        }
      }
    }
  }
}

}  // namespace
}  // namespace throng::app::place_test
