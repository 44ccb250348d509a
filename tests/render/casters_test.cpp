#include "engine/render/passes/casters.h"

#include <array>
#include <cmath>
#include <random>
#include <thread>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "throng/render/camera.h"

namespace throng::render::casters_test {
namespace {

constexpr std::array<bool, cascade_count> all_wanted{true, true, true, true};
constexpr float of_first = 1.0F, of_others = 2.5F;  // metres that surfaces reach

/// Runs each job on a thread of its own.
class Threads final : public Executor {
 public:
  void run(int count, Job job) override {
    asked_for_ = count;
    std::vector<std::thread> threads;
    for (int index = 0; index < count; ++index) threads.emplace_back(job.run, job.context, index);
    for (std::thread& thread : threads) thread.join();
  }
  int asked_for() const { return asked_for_; }

 private:
  int asked_for_ = 0;
};

/// A crowd of three batches that stands all around a camera.
class CastersOfACrowd : public testing::Test {
 protected:
  CastersOfACrowd() : instances_(150'000) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-150.0F, 150.0F), scale(0.5F, 3.0F);
    for (InstanceRecord& record : instances_) {
      record.position[0] = place(random);
      record.position[2] = place(random);
      record.scale = scale(random);
    }
    frame_.camera = view_of({.position = {0.0F, 1.7F, 0.0F}, .pitch = -0.1F}, 1.5F);
    frame_.instances = instances_;
    frame_.batches = batches_;
    cascades_ = plan_cascades(frame_.camera, axes_, {0.5F, 200.0F}, 2048);
  }

  Casters chosen(const RenderJobs& jobs, const std::array<bool, cascade_count>& wanted = all_wanted) {
    frame_.jobs = jobs;
    Casters casters;
    casters.choose(frame_, reaches_, axes_, cast_limits(cascades_, axes_, wanted));
    return casters;
  }

  std::vector<InstanceRecord> instances_;
  const std::vector<CrowdBatch> batches_{{.first = 0, .count = 70'000},
                                         {.character = 1, .mesh_lod = 1, .first = 70'000, .count = 10},
                                         {.page = 1, .character = 1, .first = 70'010, .count = 79'990}};
  const std::vector<float> reaches_{of_first, of_others};
  CrowdFrame frame_;
  const SunAxes axes_ = sun_axes(glm::normalize(glm::vec3(0.5F, 0.4F, 0.3F)));
  std::array<Cascade, cascade_count> cascades_{};
};

TEST_F(CastersOfACrowd, AreAllWhoseBallsReachOverTheMapOfACascade) {
  const Casters casters = chosen({});
  const CastLimits limits = cast_limits(cascades_, axes_, all_wanted);
  std::size_t next = 0;
  for (std::size_t cascade = 0; cascade < cascade_count; ++cascade) {
    for (std::size_t batch = 0; batch < batches_.size(); ++batch) {
      std::vector<std::uint32_t> expected;
      const std::uint32_t first = batches_[batch].first;
      for (std::uint32_t i = first; i < first + batches_[batch].count; ++i) {
        const float* const at = instances_[i].position;
        const glm::vec3 place = axes_.along({at[0], at[1], at[2]});
        if (may_cast(limits, place, reaches_[batches_[batch].character] * instances_[i].scale)[cascade] != 0)
          expected.push_back(i);
      }
      ASSERT_EQ(casters.count(cascade, batch), expected.size()) << cascade << ", " << batch;
      const auto found = casters.all().subspan(next, expected.size());
      EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin())) << cascade << ", " << batch;
      next += expected.size();
    }
  }
  EXPECT_EQ(next, casters.all().size());
  EXPECT_GT(casters.count(0, 0), 0U);
  EXPECT_LT(casters.count(0, 0), casters.count(3, 0) / 10);
}

TEST_F(CastersOfACrowd, AreTheSameForAnyNumberOfJobs) {
  const Casters alone = chosen({});
  for (const int at_once : {1, 2, 3, 8}) {
    Threads threads;
    const Casters casters = chosen({.executor = &threads, .at_once = at_once});
    EXPECT_EQ(threads.asked_for(), at_once);
    ASSERT_EQ(casters.all().size(), alone.all().size()) << at_once;
    EXPECT_EQ(casters.largest_scale(), alone.largest_scale());
    EXPECT_TRUE(std::equal(alone.all().begin(), alone.all().end(), casters.all().begin())) << at_once;
    for (std::size_t batch = 0; batch < batches_.size(); ++batch) {
      for (std::size_t i = 0; i < cascade_count; ++i) EXPECT_EQ(casters.count(i, batch), alone.count(i, batch));
    }
  }
}

// Everybody wears two pieces of three, so each batch is cut into three lists.
TEST_F(CastersOfACrowd, OfListsAreThoseOfTheirBatchesForAnyNumberOfJobs) {
  constexpr std::uint32_t pieces = 3;
  const Casters of_runs = chosen({});
  std::vector<std::uint8_t> casts(instances_.size());
  std::size_t next = 0;
  for (std::size_t cascade = 0; cascade < cascade_count; ++cascade) {
    for (std::size_t batch = 0; batch < batches_.size(); next += of_runs.count(cascade, batch++)) {
      for (const std::uint32_t i : of_runs.all().subspan(next, of_runs.count(cascade, batch)))
        casts[i] |= 1U << cascade;
    }
  }
  std::vector<CrowdBatch> lists;
  std::vector<std::uint32_t> drawn;
  for (const CrowdBatch& batch : batches_) {
    for (std::uint32_t piece = 0; piece < pieces; ++piece) {
      lists.push_back(batch);
      lists.back().first = static_cast<std::uint32_t>(drawn.size());
      for (std::uint32_t i = batch.first; i < batch.first + batch.count; ++i) {
        if (i % pieces != piece) drawn.push_back(i);
      }
      lists.back().count = static_cast<std::uint32_t>(drawn.size()) - lists.back().first;
    }
  }
  frame_.batches = lists;
  frame_.drawn = drawn;
  frame_.runs = batches_;
  for (const int at_once : {1, 2, 8}) {
    Threads threads;
    const Casters casters = chosen({.executor = &threads, .at_once = at_once});
    EXPECT_EQ(casters.largest_scale(), of_runs.largest_scale());
    std::size_t at = 0;
    for (std::size_t cascade = 0; cascade < cascade_count; ++cascade) {
      for (std::size_t list = 0; list < lists.size(); ++list) {
        std::vector<std::uint32_t> expected;
        for (const std::uint32_t i : std::span(drawn).subspan(lists[list].first, lists[list].count)) {
          if ((casts[i] >> cascade & 1U) != 0) expected.push_back(i);
        }
        ASSERT_EQ(casters.count(cascade, list), expected.size()) << at_once;
        ASSERT_TRUE(std::ranges::equal(casters.all().subspan(at, expected.size()), expected)) << at_once;
        at += expected.size();
      }
    }
    EXPECT_EQ(at, casters.all().size());
  }
}

TEST_F(CastersOfACrowd, AreNoneOfACascadeThatIsNotWanted) {
  const Casters all = chosen({}), some = chosen({}, {true, false, true, false});
  for (std::size_t batch = 0; batch < batches_.size(); ++batch) {
    for (const std::size_t cascade : {0U, 2U}) EXPECT_EQ(some.count(cascade, batch), all.count(cascade, batch));
    for (const std::size_t cascade : {1U, 3U}) EXPECT_EQ(some.count(cascade, batch), 0U);
  }
}

TEST_F(CastersOfACrowd, AreNoneWhereThereIsNobody) {
  frame_.batches = {};
  Casters casters;
  casters.choose(frame_, {}, axes_, cast_limits(cascades_, axes_, all_wanted));
  EXPECT_TRUE(casters.all().empty());
}

}  // namespace
}  // namespace throng::render::casters_test
