// These tests run the real program. It must never crash, hang, lose a file, or end without a word.
#include <algorithm>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "app/show/recording/recording.h"
#include "tests/app/program_run.h"
#include "tests/app/temporary_folder.h"
#include "tests/sanitized.h"

namespace throng::app::program_faults_test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

class Faults : public test::TemporaryFolder {
 protected:
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  static std::string read(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
  }
  std::string model() const {
    const fs::path model = folder_ / "walker.glb";
    fs::copy_file(THRONG_SOURCE_DIR "/assets/mannequin.glb", model, fs::copy_options::skip_existing);
    return model.string();
  }
  /// Runs a short crowd without pictures, with more arguments.
  static ProgramRun run(std::vector<std::string> arguments) {
    for (const char* const each : {"--headless=none", "--agents", "10", "--frames", "2", "--pus", "1"}) {
      arguments.emplace_back(each);
    }
    return run_program(arguments);
  }
};

/// Expects one line that begins with the program's name, and this exit status.
void expect_one_line(const ProgramRun& run, int status, const std::string& line) {
  EXPECT_EQ(run.exit_status, status);
  EXPECT_EQ(run.errors, "throng: " + line + "\n");
}

TEST_F(Faults, ARunWithoutAWindowEndsWithALineThatNamesAllThatItWrote) {
  const ProgramRun wrote = run({"--stats", at("a.json"), "--record", at("b.rec")});
  EXPECT_THAT(wrote.errors, AllOf(StartsWith("throng: 2 frames in "),
                                  EndsWith("; wrote " + at("a.json") + " and " + at("b.rec") + "\n")));
  EXPECT_EQ(wrote.output, "");
  EXPECT_THAT(run({}).errors, EndsWith("; no option named a file to write\n"));
}

TEST_F(Faults, ARunWithStatisticsOnStandardOutputSaysNothingElseThere) {
  const ProgramRun told = run({"--stats", "-"});
  EXPECT_THAT(told.output, AllOf(StartsWith("{"), EndsWith("}\n")));
  EXPECT_THAT(told.errors, StartsWith("throng: 2 frames in "));
}

TEST_F(Faults, ARecordingWithADeepHeaderIsRefused) {
  const std::string header(100'000, '[');
  const auto bytes = [](std::uint32_t number) {
    return std::string(reinterpret_cast<const char*>(&number), sizeof(number));
  };
  std::ofstream(at("deep.rec"), std::ios::binary)
      << "THRONGRC" << bytes(recording_version) << bytes(static_cast<std::uint32_t>(header.size())) << header;
  expect_one_line(run_program({"--replay", at("deep.rec"), "--headless=none"}), 1,
                  at("deep.rec") + ": is damaged in its header: is nested deeper than 64 levels");
}

TEST_F(Faults, AFolderWhereAFileBelongsIsNamed) {
  fs::create_directory(at("walker.glb.throng.json"));
  expect_one_line(run({model()}), 1, model() + ".throng.json: it is a folder, not a file; name a file of JSON");
  fs::remove(at("walker.glb.throng.json"));
  fs::create_directory(at("walker.glb.lod.json"));
  expect_one_line(run({model()}), 1, model() + ".lod.json: it is a folder, not a file; name a file of JSON");
  expect_one_line(run_program({"--replay", folder_.string(), "--headless=none"}), 1,
                  folder_.string() + ": it is a folder, not a file; name a recording of throng");
}

TEST_F(Faults, APipeIsNotWaitedFor) {
  ASSERT_EQ(mkfifo(at("pipe.json").c_str(), 0600), 0);
  expect_one_line(run({"--preset", at("pipe.json")}), 2,
                  "--preset " + at("pipe.json") + ": it is a pipe, not a file; name a preset");
  expect_one_line(run({"--stats", at("pipe.json")}), 1, at("pipe.json") + ": cannot be written: it has no reader");
}

TEST_F(Faults, AnOutputNeverReplacesAnInput) {
  const auto before = fs::file_size(model());
  expect_one_line(run({model(), "--stats", model()}), 1,
                  "--stats " + model() + ": the model reads this file; name another");
  EXPECT_EQ(fs::file_size(model()), before);
  fs::create_symlink(model(), at("link.json"));
  EXPECT_THAT(run({model(), "--stats", at("link.json")}).errors, HasSubstr("the model reads this file"));
  EXPECT_EQ(fs::file_size(model()), before);
  std::ofstream(at("scene.gltf"))
      << R"({"asset":{"version":"2.0"},"buffers":[{"uri":"my%20data.bin","byteLength":4}]})";
  std::ofstream(at("my data.bin")) << "four";
  EXPECT_THAT(run({at("scene.gltf"), "--stats", at("my data.bin")}).errors, HasSubstr("the model reads this file"));
  EXPECT_EQ(read(at("my data.bin")), "four");
}

TEST_F(Faults, TwoOutputsOfOneNameAreRefused) {
  const std::string other = (folder_ / "." / "run.json").string();
  expect_one_line(run({"--stats", at("run.json"), "--trace", other}), 1,
                  "--trace " + other + ": --stats writes this file too; name another");
  EXPECT_EQ(run({"--stats", "/dev/null", "--trace", "/dev/null"}).exit_status, 0);
}

TEST_F(Faults, AFullDiskIsSaid) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"--help"}, {"bench", "--agents", "10", "--frames", "1"}, {"inspect", model()}}) {
    const ProgramRun run = run_program(arguments, {.output = "/dev/full"});
    expect_one_line(run, 1, "standard output: cannot be written: No space left on device");
  }
}

TEST_F(Faults, ASignalEndsARunWithAllThatItHas) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const ProgramRun run =
        run_program({"--headless=none", "--agents", "10", "--pus", "1", "--frames", "1000000000", "--stats",
                     at("stats.json"), "--record", at("run.rec"), "--trace", at("trace.json")},
                    {.meanwhile = send(signal, at("run.rec") + ".PID.part")});
    EXPECT_EQ(run.exit_status, 128 + signal) << run.errors;
    for (const char* const file : {"stats.json", "run.rec", "trace.json"}) EXPECT_TRUE(fs::exists(at(file))) << file;
    EXPECT_EQ(run_program({"--replay", at("run.rec"), "--headless=none"}).exit_status, 0) << "it is whole";
    for (const char* const file : {"stats.json", "run.rec", "trace.json"}) fs::remove(at(file));
  }
}

TEST_F(Faults, AKilledRunLeavesOldFilesAndAPartThatTheNextRunNames) {
  std::ofstream(at("run.rec")) << "old";
  const ProgramRun killed = run_program(
      {"--headless=none", "--agents", "10", "--pus", "1", "--frames", "1000000000", "--record", at("run.rec")},
      {.meanwhile = send(SIGKILL, at("run.rec") + ".PID.part")});
  EXPECT_EQ(killed.exit_status, 128 + SIGKILL);
  EXPECT_EQ(read(at("run.rec")), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2);
  EXPECT_THAT(run({"--record", at("run.rec")}).errors,
              AllOf(StartsWith("throng: " + at("run.rec.")), HasSubstr("--remove-parts removes it\n")));
  EXPECT_THAT(run({"--record", at("run.rec"), "--remove-parts"}).errors, HasSubstr(" is removed"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(Faults, WhatIsRecordedCanBeReplayed) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"--dt", "3600"}, {"--dt", "1e-6"}, {"--camera", "1e6,1e6,-1e6,0,0"}}) {
    std::vector<std::string> recorded = arguments;
    recorded.insert(recorded.end(), {"--record", at("run.rec")});
    ASSERT_EQ(run(recorded).exit_status, 0) << arguments.back();
    const ProgramRun replayed = run_program({"--headless=none", "--replay", at("run.rec")});
    EXPECT_EQ(replayed.exit_status, 0) << arguments.back() << replayed.errors;
  }
  EXPECT_EQ(run({"--dt", "3601"}).exit_status, 2);
  EXPECT_EQ(run({"--dt", "1e-300"}).exit_status, 2);
  EXPECT_EQ(run({"--camera", "2e6,0,0,0,0"}).exit_status, 2);
}

TEST_F(Faults, AModelWhoseNameIsNoUtf8IsRecordedAndReplayed) {
  const std::string odd = at("walker\xff.glb");
  fs::rename(model(), odd);
  ASSERT_EQ(run({odd, "--record", at("run.rec")}).exit_status, 0);
  const ProgramRun replayed = run_program({"--headless=none", "--replay", at("run.rec")});
  EXPECT_EQ(replayed.exit_status, 0) << replayed.errors;
}

TEST_F(Faults, MemoryThatIsNotThereIsRefusedBeforeItIsTaken) {
  if (throng::test::sanitized) return;
  const ProgramRun units = run_program({"--headless=none", "--frames", "2", "--pus", "256", "--local-store", "65536"},
                                       {.address_space = std::uint64_t{4} << 30U});
  EXPECT_EQ(units.exit_status, 1);
  EXPECT_THAT(units.errors, AllOf(StartsWith("throng: 256 PUs with local stores of 64.0 MiB need 32.0 GiB of memory"),
                                  EndsWith("; ask for fewer --pus or a smaller --local-store\n")));
  const ProgramRun agents = run_program({"bench", "--agents", "100000", "--bones", "1024", "--frames", "1"},
                                        {.address_space = std::uint64_t{4} << 30U});
  EXPECT_EQ(agents.exit_status, 1);
  EXPECT_THAT(agents.errors, StartsWith("throng: 100000 agents of 1024 bones, and their PUs, need "));
}

TEST_F(Faults, NoMemoryLeftIsOneLine) {
  if (throng::test::sanitized) return;
  for (const std::uint64_t mebibytes : {60U, 80U, 100U, 150U, 200U, 300U}) {
    const ProgramRun small = run_program({"--headless=none", "--frames", "2", "--pus", "2", "--agents", "20000"},
                                         {.address_space = mebibytes << 20U});
    EXPECT_THAT(small.exit_status, testing::AnyOf(0, 1)) << mebibytes << small.errors;
    EXPECT_EQ(std::ranges::count(small.errors, '\n'), 1) << mebibytes << small.errors;
    if (small.exit_status == 0) continue;
    EXPECT_THAT(
        small.errors,
        testing::AnyOf(HasSubstr(" are left; ask for fewer --agents"), EndsWith("raise the limit (ulimit -v)\n"),
                       HasSubstr(": there is not enough memory to import it; close other programs")));
  }
}

TEST_F(Faults, DriversGetTheMemoryThatTheyNeedOrAreNotOpened) {
  if (throng::test::sanitized) return;
  for (const std::uint64_t mebibytes : {150U, 300U, 375U, 550U, 900U}) {
    const ProgramRun picture =
        run_program({"--headless", "--agents", "2", "--frames", "1", "--screenshot", at("picture.png")},
                    {.address_space = mebibytes << 20U});
    EXPECT_EQ(picture.exit_status, 1) << mebibytes;
    EXPECT_THAT(picture.errors,
                AllOf(StartsWith("throng: drawing needs "), EndsWith(" are left; raise the limit (ulimit -v)\n")));
  }
}

TEST_F(Faults, AFileThatIsLostTakesNoOtherWithIt) {
  const ProgramRun full = run({"--stats", "/dev/full", "--trace", at("trace.json"), "--record", at("run.rec")});
  expect_one_line(full, 1, "/dev/full: cannot be written: No space left on device");
  EXPECT_TRUE(fs::exists(at("trace.json")));
  EXPECT_TRUE(fs::exists(at("run.rec")));
}

TEST_F(Faults, CoresThatItMayNotUseAreNotUsed) {
  const auto pus = [&](std::vector<std::size_t> cores) {
    const ProgramRun pinned =
        run_program({"--headless=none", "--frames", "1", "--stats", "-"}, {.cores = std::move(cores)});
    return pinned.output.substr(pinned.output.find("\"pus\":"), 9);
  };
  EXPECT_THAT(pus({0}), HasSubstr(" 1,"));
}

}  // namespace
}  // namespace throng::app::program_faults_test
