// Agents that wear pieces of a mesh, which are drawn through lists of those who wear them.
#include <algorithm>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "tests/gl/doll_crowd.h"
#include "tests/gl/gl_test.h"
#include "tests/gl/picture_tolerance.h"

namespace throng::render::test::outfits_test {
namespace {

constexpr std::uint32_t crowd_size = 15;

/// A doll in two pieces, legs and shoes and the rest, which together are all of it; and a silhouette that is all of it.
struct DollInPieces {
  explicit DollInPieces(const Doll& doll) : data(doll.mesh_data()) {
    const MeshPartData whole = data.parts.front();
    const auto begin = whole.indices.begin();
    for (std::size_t i = 0; i < whole.indices.size(); i += 3) {
      std::vector<std::uint32_t>& half = whole.regions[whole.indices[i]] >= 3 ? lower : upper;
      half.insert(half.end(), begin + static_cast<std::ptrdiff_t>(i), begin + static_cast<std::ptrdiff_t>(i) + 3);
    }
    faces.assign(whole.positions.size() / 3 * 4, 1.0F);
    data.body_size = 20.0F;  // so that a face's centimetre is seen
    MeshPartData one = whole, other = whole;
    one.faces = faces;
    one.indices = upper;
    other.indices = lower;
    data.pieces = {{.levels = {{{one}, 0.0F}, {{one}, 0.01F}}},
                   {.levels = {{{other}, 0.0F}, {{other}, 0.01F}}},
                   {.levels = {{{whole}, 0.1F}}, .is_silhouette = true},
                   {.levels = {{{other}, 0.0F}}, .is_silhouette = true}};
  }
  std::vector<std::uint32_t> upper, lower;
  std::vector<float> faces;
  CrowdMeshData data;
};

class Outfits : public SoftwareGlTest {
 protected:
  void SetUp() override {
    SoftwareGlTest::SetUp();
    crowd_ = std::make_unique<DollCrowd>(context());
    crowd_->stand(crowd_size);
    crowd_->write_palettes();
    doll_ = std::make_unique<DollInPieces>(crowd_->doll());
    const std::vector<CrowdMeshData> dolls(2, doll_->data);
    ASSERT_TRUE(crowd_->renderer().load_characters(dolls));
  }
  void TearDown() override {
    crowd_.reset();
    SoftwareGlTest::TearDown();
  }

  DollCrowd& crowd() { return *crowd_; }

  /// A frame in which everybody wears these pieces, each drawn from a list of its own.
  CrowdFrame wearing(const std::vector<std::uint16_t>& pieces, std::uint8_t mesh_lod) {
    CrowdFrame frame = crowd().frame();
    runs_.assign(frame.batches.begin(), frame.batches.end());
    lists_.clear();
    drawn_.clear();
    for (const CrowdBatch& run : runs_) {
      for (const std::uint16_t piece : pieces) {
        CrowdBatch& list = lists_.emplace_back(run);
        list.piece = piece;
        list.mesh_lod = mesh_lod;
        list.first = static_cast<std::uint32_t>(drawn_.size());
        for (std::uint32_t i = 0; i < run.count; ++i) drawn_.push_back(run.first + i);
      }
    }
    frame.batches = lists_;
    frame.drawn = drawn_;
    frame.runs = runs_;
    return frame;
  }
  /// The same with a silhouette that stands in for the pieces.
  CrowdFrame wearing(const std::vector<std::uint16_t>& pieces, std::uint8_t mesh_lod, std::uint16_t stand_in) {
    std::vector<std::uint16_t> all = pieces;
    all.push_back(stand_in);
    const CrowdFrame frame = wearing(all, mesh_lod);
    for (CrowdBatch& list : lists_) list.stands_in = list.piece == stand_in;
    return frame;
  }
  Image picture(const CrowdFrame& frame) {
    crowd().renderer().draw(frame);
    return crowd().renderer().read_image();
  }
  PictureDifference difference(const CrowdFrame& one, const CrowdFrame& other) {
    const Image first = picture(one);
    return *measure_difference(first, picture(other));
  }

 private:
  std::unique_ptr<DollCrowd> crowd_;
  std::unique_ptr<DollInPieces> doll_;
  std::vector<CrowdBatch> runs_, lists_;
  std::vector<std::uint32_t> drawn_;
};

TEST_F(Outfits, OfPlainCottonThatAreAllOfACharacterLookLikeIt) {
  const Image whole = picture(crowd().frame());
  const PictureDifference near = *measure_difference(whole, picture(wearing({1, 2}, 0)));
  EXPECT_LT(near.mean, 0.02);
  EXPECT_LT(near.worst_block, 1.0);
  EXPECT_EQ(measure_difference(whole, picture(wearing({3}, 4)))->worst_block, 0.0) << "with shadows";
}

TEST_F(Outfits, WithoutAPieceShowThatItIsMissing) {
  EXPECT_FALSE(looks_the_same(difference(crowd().frame(), wearing({1}, 0))));
  EXPECT_FALSE(looks_the_same(difference(crowd().frame(), wearing({2}, 0))));
}

TEST_F(Outfits, FollowTheFaceOfALookNearBy) {
  const Image near = picture(wearing({1, 2}, 0)), far = picture(wearing({3}, 4));
  for (AgentLook& look : crowd().looks) look.face = 0x00007F00U;  // the nose
  EXPECT_FALSE(looks_the_same(*measure_difference(near, picture(wearing({1, 2}, 0)))));
  EXPECT_EQ(measure_difference(far, picture(wearing({3}, 4)))->worst_block, 0.0);
}

TEST_F(Outfits, AreShadowsAndLabelsAndBonesOfTheSameAgents) {
  CrowdFrame whole = crowd().frame(), worn = wearing({1, 2}, 0);
  const std::vector<PixelBox> boxes(crowd_size, {0, 0, DollCrowd::width, DollCrowd::height});
  std::vector<BodyAlone> meant(crowd_size), bodies(crowd_size);
  LabelPicture meant_labels, labels;
  whole.bones_as_lines = worn.bones_as_lines = true;
  const Image with_bones = picture(whole);
  ASSERT_TRUE(crowd().renderer().draw_labels(whole, meant_labels));
  ASSERT_TRUE(crowd().renderer().measure_bodies(whole, boxes, meant));
  EXPECT_LT(measure_difference(with_bones, picture(worn))->worst_block, 1.0);
  ASSERT_TRUE(crowd().renderer().draw_labels(worn, labels));
  ASSERT_TRUE(crowd().renderer().measure_bodies(worn, boxes, bodies));
  EXPECT_EQ(labels.agents, meant_labels.agents);
  for (std::size_t i = 0; i < crowd_size; ++i) {
    EXPECT_EQ(bodies[i].pixels, meant[i].pixels) << i;
    EXPECT_EQ(bodies[i].box, meant[i].box) << i;
    EXPECT_GT(bodies[i].pixels, 100U) << i;
  }
}

TEST_F(Outfits, AreSeenAsTheyAreWhateverStandsInForThem) {
  CrowdFrame plain = wearing({1, 2}, 0);
  plain.shadows = false;
  const Image meant = picture(plain);
  CrowdFrame with_stand_in = wearing({1, 2}, 0, 4);
  with_stand_in.shadows = false;
  EXPECT_EQ(measure_difference(meant, picture(with_stand_in))->worst_block, 0.0);
}

TEST_F(Outfits, CastTheShadowsOfASilhouetteWhereATexelHidesTheDifference) {
  const std::uint64_t alone = crowd().renderer().draw(wearing({1, 2}, 0)).triangles;
  const std::uint64_t coarse = crowd().renderer().draw(wearing({1, 2}, 0, 3)).triangles;
  const std::uint64_t exact = crowd().renderer().draw(wearing({1, 2}, 0, 4)).triangles;
  EXPECT_EQ(coarse, alone) << "a silhouette that is off by ten centimetres";
  EXPECT_LT(exact, alone) << "one that is off by nothing, and half as large";
}

TEST_F(Outfits, TakeOneMoreCallThanPeopleHoweverManyPieces) {
  CrowdFrame few = wearing({1}, 0);
  few.shadows = few.crowd_shade = false;
  const DrawCounts of_few = crowd().renderer().draw(few);
  CrowdFrame many = wearing({1, 2}, 0);
  many.shadows = many.crowd_shade = false;
  EXPECT_EQ(crowd().renderer().draw(many).draw_calls, of_few.draw_calls);
}

}  // namespace
}  // namespace throng::render::test::outfits_test
