#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/benchmark/programs/machine.h"
#include "tests/own_folder.h"

namespace throng::app::machine_model_test {
namespace {

/// 100 ns to the first byte, then a byte a nanosecond, one transfer at a time.
Machine simple_machine() {
  return {.name = "simple", .local_store_kib = 16, .pus = 1, .dma_latency_ns = 100, .dma_gigabytes_per_second = 1};
}

std::string refusal_of(const std::string& json) {
  const throng::test::OwnFolder folder;
  const std::filesystem::path file = folder.path() / "machine.json";
  std::ofstream(file) << json;
  const auto machine = read_machine(file);
  return machine ? "" : machine.error().message;
}

TEST(Dma, TakesItsLatencyForEachTransferAndThenTimeByByte) {
  EXPECT_DOUBLE_EQ(dma_time(simple_machine(), {.bytes_in = 300, .bytes_out = 200, .transfers = 2}), 700);
  EXPECT_DOUBLE_EQ(dma_time(simple_machine(), {}), 0);
}

TEST(Dma, HidesLatenciesOfTransfersInFlightBehindEachOther) {
  Machine machine = simple_machine();
  machine.dma_transfers_in_flight = 16;
  EXPECT_DOUBLE_EQ(dma_time(machine, {.bytes_in = 0, .bytes_out = 0, .transfers = 16}), 100);
  EXPECT_DOUBLE_EQ(dma_time(machine, {.bytes_in = 0, .bytes_out = 0, .transfers = 17}), 200);
}

TEST(Prediction, HidesCopiesBehindComputingUntilTheyTakeLonger) {
  const RecordedTask hidden{.compute_ns = 1000, .while_computing = {400, 0, 1}, .before = {}, .after = {}};
  const RecordedTask stalls{.compute_ns = 1000, .while_computing = {1400, 0, 1}, .before = {}, .after = {}};
  EXPECT_DOUBLE_EQ(predict(simple_machine(), {&hidden, 1}).busy_ns, 1000);
  EXPECT_DOUBLE_EQ(predict(simple_machine(), {&hidden, 1}).stall_ns, 0);
  EXPECT_DOUBLE_EQ(predict(simple_machine(), {&hidden, 1}).overlap(), 1);
  EXPECT_DOUBLE_EQ(predict(simple_machine(), {&stalls, 1}).busy_ns, 1500);
  EXPECT_DOUBLE_EQ(predict(simple_machine(), {&stalls, 1}).stall_ns, 500);
}

TEST(Prediction, HidesNothingOfTheFirstFetchAndTheLastWriteBack) {
  const RecordedTask task{.compute_ns = 1000, .while_computing = {}, .before = {100, 0, 1}, .after = {0, 50, 1}};
  EXPECT_DOUBLE_EQ(predict(simple_machine(), {&task, 1}).stall_ns, 200 + 150);
  EXPECT_DOUBLE_EQ(predict(simple_machine(), {&task, 1}).busy_ns, 1350);
}

TEST(Prediction, ComputesAsManyTimesAsLongOrByBone) {
  const RecordedTask task{.compute_ns = 1000, .bones = 20, .while_computing = {}, .before = {}, .after = {}};
  Machine machine = simple_machine();
  machine.compute_times = 3;
  EXPECT_DOUBLE_EQ(predict(machine, {&task, 1}).busy_ns, 3000);
  machine.compute_ns_per_bone = 600;
  EXPECT_DOUBLE_EQ(predict(machine, {&task, 1}).busy_ns, 12000);
}

TEST(RecordedTasks, AreWhatATraceWithDoubleBufferingSays) {
  using Kind = anim::TraceSpan::Kind;
  const std::vector<anim::TraceSpan> spans = {{0, 10, 0, 0, 0, Kind::schedule},      {10, 20, 500, 0, 5, Kind::fetch},
                                              {20, 30, 600, 0, 6, Kind::fetch},      {30, 130, 0, 0, 0, Kind::compute},
                                              {130, 140, 0, 50, 5, Kind::fetch},     {140, 340, 0, 0, 0, Kind::compute},
                                              {340, 350, 0, 60, 6, Kind::write_back}};
  anim::UpdateTime time;
  time.milliseconds = 1e-3;  // a tick is a nanosecond
  time.first_tick = 0;
  time.last_tick = 1000;
  const std::vector<RecordedTask> tasks =
      recorded_tasks(spans, time, {.bones = 10, .stream_bytes = 2000, .stream_reads = 4});
  ASSERT_EQ(tasks.size(), 2U);
  EXPECT_EQ(tasks[0].before.bytes_in, 500U) << "nothing is computed yet";
  EXPECT_EQ(tasks[0].while_computing.bytes_in, 600U + 1000U) << "the next task, and rows";
  EXPECT_EQ(tasks[0].while_computing.transfers, 6U + 2U);
  EXPECT_NEAR(tasks[0].compute_ns, 100, 1e-9);
  EXPECT_EQ(tasks[1].while_computing.bytes_out, 50U) << "what the first left";
  EXPECT_EQ(tasks[1].after.bytes_out, 60U);
  EXPECT_DOUBLE_EQ(tasks[1].bones, 5);
}

TEST(MachineFile, OfEachPresetIsRead) {
  for (const char* const preset : {"ps2", "spe"}) {
    const auto machine = read_machine(std::string(THRONG_SOURCE_DIR "/tests/benchmark/machines/") + preset + ".json");
    ASSERT_TRUE(machine.has_value()) << machine.error().message;
    EXPECT_FALSE(machine->name.empty());
  }
  EXPECT_EQ(read_machine(THRONG_SOURCE_DIR "/tests/benchmark/machines/ps2.json")->local_store_kib, 16);
  EXPECT_EQ(read_machine(THRONG_SOURCE_DIR "/tests/benchmark/machines/spe.json")->local_store_kib, 256);
}

TEST(PapersMachine, IsPredictedWithThePapersScheduleAndStream) {
  BenchOptions options;
  options.agents = {16};
  options.schedules = {anim::Schedule::levels};
  options.streams = {anim::StreamKind::keyframe};
  options.frames = 2;
  const auto machine = read_machine(THRONG_SOURCE_DIR "/tests/benchmark/machines/ps2.json");
  ASSERT_TRUE(machine) << machine.error().message;
  const auto found = run_machine(options, *machine);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_GE(found->json["largest_skeleton_bones"].get<int>(), 62) << "the paper's, in 8 KiB twice";
  EXPECT_GT(found->json["characters_per_60hz_frame"].get<int>(), 40);
  EXPECT_EQ(found->json["paper_case_reported_percent_of_frame"].get<double>(), 6.0);
  EXPECT_NEAR(found->json["paper_case_predicted_percent_of_frame"].get<double>(), 6.0, 1.0);
}

TEST(MachineFile, IsRefusedInALineThatNamesTheKey) {
  using testing::HasSubstr;
  const std::string rest =
      R"("pus": 1, "dma_latency_ns": 1, "dma_gigabytes_per_second": 1, "dma_transfers_in_flight": 1})";
  const std::string whole = R"({"name": "a", "local_store_kib": 16, )" + rest;
  EXPECT_EQ(refusal_of(whole), "");
  EXPECT_THAT(refusal_of("[1, 2]"), HasSubstr("must be an object"));
  EXPECT_THAT(refusal_of("{\"name\": \"a\", " + rest), HasSubstr("\"local_store_kib\" is missing"));
  EXPECT_THAT(refusal_of(R"({"name": 3, "local_store_kib": 16, )" + rest), HasSubstr("\"name\" must be a text"));
  EXPECT_THAT(refusal_of(R"({"name": "a", "local_store_kib": 1.5, )" + rest), HasSubstr("whole number"));
  EXPECT_THAT(refusal_of(R"({"name": "a", "local_store_kib": -1, )" + rest),
              HasSubstr("must be a whole number, 1 to 65536"));
  EXPECT_THAT(refusal_of(R"({"name": "a", "cores": 3, "local_store_kib": 16, )" + rest),
              HasSubstr("unknown key \"cores\""));
  EXPECT_THAT(
      refusal_of(R"({"name": "a", "compute_times": 3, "compute_ns_per_bone": 3, "local_store_kib": 16, )" + rest),
      HasSubstr("contradicts"));
}

}  // namespace
}  // namespace throng::app::machine_model_test
