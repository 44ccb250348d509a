#include "app/show/figures/notices.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "throng/heap_pages.h"

#include "engine/anim/asset/synthetic_model.h"

namespace throng::app::notices_test {
namespace {

using testing::HasSubstr;

std::unique_ptr<anim::AnimationSystem> system_of(int bones, const anim::SystemOptions& options) {
  const auto character = std::make_shared<const anim::Character>(anim::bake_character(anim::synthetic_model(bones, 2)));
  return std::move(*anim::AnimationSystem::create(character, options));
}

TEST(SoftwareNotice, NamesWhatIsSparedAndNothingElse) {
  EXPECT_EQ(
      software_notice("llvmpipe", {.no_multisampling = true, .no_shadows = true, .error_px = 3}),
      "No graphics card draws here; the processor does, by llvmpipe. To keep up it starts with no multisampling, no "
      "shadows and errors of up to 3 pixels; --msaa, --shadows and --error-px change that.");
  EXPECT_EQ(software_notice("llvmpipe", {.agents = 300, .no_shadows = true}),
            "No graphics card draws here; the processor does, by llvmpipe. To keep up it starts with 300 agents and no "
            "shadows; --agents and --shadows change that.");
  EXPECT_EQ(software_notice("llvmpipe", {}), "");
}

TEST(LocalStoreNotice, SaysThatAnAutomaticStoreIsLargerThanUsual) {
  const anim::SystemOptions keyframes{.stream = anim::StreamKind::keyframe};
  EXPECT_EQ(local_store_notice(*system_of(62, keyframes)), "");
  EXPECT_THAT(local_store_notice(*system_of(200, keyframes)), HasSubstr("KiB instead of 64 KiB"));
}

TEST(LocalStoreNotice, SaysNothingOfAStoreThatWasAskedFor) {
  const anim::SystemOptions large{.local_store_bytes = std::size_t{256} * 1024, .stream = anim::StreamKind::keyframe};
  EXPECT_EQ(local_store_notice(*system_of(200, large)), "");
}

TEST(PaletteNotice, SaysThatMemoryRanOut) {
  constexpr std::uint32_t entries = 4;
  constexpr std::size_t bytes = anim::palette_stride(entries, PaletteFormat::matrices);
  struct OnePage final : render::PalettePageSource {
    render::PalettePage add_page() override { return left-- > 0 ? heap.add_page() : render::PalettePage{}; }
    HeapPageSource heap{bytes};
    int left = 1;
  } page;
  PaletteSlots slots(page, {bytes});
  ShownPoses shown(slots);
  shown.reset(2, 0);
  shown.show({.agent = 0, .level = 0, .entries = entries, .time = 0}, 0, 0);
  EXPECT_EQ(palette_notice(shown), "");
  shown.show({.agent = 1, .level = 0, .entries = entries, .time = 0}, 0, 0);
  EXPECT_THAT(palette_notice(shown), HasSubstr("Palette memory ran out"));
}

TEST(PlacementNotice, SaysWhoIsShownInAnotherSizeOrPlaceAndHowToOverruleIt) {
  const std::string file = THRONG_SOURCE_DIR "/assets/mannequin.glb";
  std::vector<CharacterSource> people;
  people.push_back(*load_character(file, "plain"));
  EXPECT_EQ(placement_notice(people), "");
  people.push_back(*load_character(file, "large", nullptr, {.placement = {.scale = 2.0}}));
  EXPECT_THAT(placement_notice(people), testing::MatchesRegex("large: 3.6 m tall: scaled by 2 as asked; --scale, "
                                                              "--up and --ground overrule it."));
}

TEST(PlacementNotice, SaysWhoIsMadeToFitAmongPeople) {
  std::vector<CharacterSource> people;
  const std::string column = THRONG_SOURCE_DIR "/tests/data/features/joints-8-influences.glb";
  people.push_back(*load_character(column, "column"));
  EXPECT_NEAR(people[0].roles.height, 1.8, 1e-3) << "4.5 m in its file";
  EXPECT_THAT(placement_notice(people), HasSubstr("1.8 m tall: scaled by 0.4 from 4.5 m to fit among people; --scale"));
  people[0] = *load_character(column, "column", nullptr, {.placement = {.scale = 1.0}});
  EXPECT_NEAR(people[0].roles.height, 4.5, 1e-3) << "as asked";
}

TEST(PlacementNotice, SaysOnceWhatHoldsForSeveral) {
  std::vector<CharacterSource> people(3);
  for (CharacterSource& person : people) {
    person.placement.is_plain = false;
    person.placement.reasons = "raised 1 m";
  }
  people[0].file = "a.glb";
  people[1].file = "b.glb";
  people[2].file = "c.glb";
  people[1].placement.reasons = "turned";
  EXPECT_EQ(placement_notice(people), "a.glb and c.glb: raised 1 m.\nb.glb: turned.");
}

TEST(ImportNotice, OfALargeCastKeepsToAFewLines) {
  std::vector<CharacterSource> people(20);
  for (std::size_t i = 0; i < people.size(); ++i) {
    people[i].file = std::to_string(i) + ".glb";
    people[i].notes = {"clips were taken"};
  }
  const std::string lines = import_notice(people);
  EXPECT_EQ(std::ranges::count(lines, '\n'), 12);
  EXPECT_TRUE(
      lines.ends_with("11.glb: clips were taken.\n8 more lines are about other models; throng inspect says what "
                      "is in a file."))
      << lines;
}

TEST(ImportNotice, NamesTheFileOrTheBuiltInCharacter) {
  std::vector<CharacterSource> people(2);
  people[0].name = "mannequin (built in)";
  people[1].name = people[1].file = "somewhere/person.glb";
  for (CharacterSource& person : people) person.notes = {"clips were taken"};
  EXPECT_EQ(import_notice(people), "mannequin (built in): clips were taken.\nperson.glb: clips were taken.");
}

TEST(RulesNotice, SaysOnceForEachFileWhatItDoubts) {
  Clothing doubted, other;
  doubted.origin = "mine.cast.json", doubted.doubts = {"a scene is none; name another"};
  other.origin = "other.cast.json";
  EXPECT_EQ(rules_notice(std::vector{doubted, other, doubted}), "mine.cast.json: a scene is none; name another.");
}

class PaletteFormatNotice : public testing::Test {
 protected:
  PaletteFormatNotice() {
    const std::string folder = THRONG_SOURCE_DIR "/tests/data/features/";
    for (const std::string name : {"plain", "linear-trs"})
      people_.push_back(*load_character(folder + name + ".glb", name));
  }
  std::string notice(PaletteFormat palettes) {
    const auto system = std::move(*anim::AnimationSystem::create(people_[0].character, {.palettes = palettes}));
    EXPECT_TRUE(system->characters().add(people_[1].character));
    return palette_format_notice(*system, people_);
  }
  std::vector<CharacterSource> people_;
};

TEST_F(PaletteFormatNotice, NamesWhoStaysFloat) {
  EXPECT_EQ(notice(PaletteFormat::packed), "Palettes stay float of linear-trs: packed ones hold rigid skeletons only.");
}

TEST_F(PaletteFormatNotice, SaysNothingUnlessPackedWasAskedFor) { EXPECT_EQ(notice(PaletteFormat::matrices), ""); }

TEST(StreamNotice, NamesCharactersWithoutKeysWhereKeysAreToBePlayed) {
  auto lean = std::make_shared<anim::Character>(anim::bake_character(anim::synthetic_model(8, 1)));
  anim::keep_played_streams(*lean);
  std::vector<CharacterSource> people(1);
  people[0].name = "town.pack";
  people[0].character = lean;
  const auto keys = std::move(*anim::AnimationSystem::create(lean, {.stream = anim::StreamKind::keyframe}));
  EXPECT_EQ(stream_notice(*keys, people),
            "town.pack: played from rows, because the pack has no keys; throng bake --keep-keys packs them.");
  const auto rows = std::move(*anim::AnimationSystem::create(lean, {}));
  EXPECT_EQ(stream_notice(*rows, people), "");
}

TEST(PlanNotice, SaysHowManyLinesAreTooMany) {
  EXPECT_EQ(plan_notice(30'000, 20'000),
            "Walls and floors are left out: the place has 30000 lines, and 20000 are the most; --walls names simpler "
            "ones.");
  EXPECT_EQ(plan_notice(9'000, 20'000),
            "Walls and floors are left out: the place has 9000 lines, and they cross each other too often; --walls "
            "names simpler ones.");
}

TEST(TracksNotice, SaysOfALiveCrowdThatRowsCome) {
  Trajectories live;
  live.file = "-", live.format = "table", live.is_live = true;
  EXPECT_EQ(tracks_notice(live), "-: table, rows as they come.");
}

TEST(TracksNotice, CountsOneOddThingAsOne) {
  Trajectories tracks;
  tracks.file = "walk.csv", tracks.format = "table", tracks.row_count = 12345;
  tracks.report.found.emplace_back().count = 1;
  EXPECT_EQ(tracks_notice(tracks), "walk.csv: table, 0 people, 12,345 rows. throng inspect lists 1 odd thing in it.");
}

TEST(Lines, AreOneASentence) {
  std::string lines;
  add_line(lines, "");
  add_line(lines, "one");
  add_line(lines, "");
  add_line(lines, "two");
  EXPECT_EQ(lines, "one\ntwo");
}

}  // namespace
}  // namespace throng::app::notices_test
