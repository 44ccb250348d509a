#include "app/show/contexts.h"

#include <cstdlib>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/program_run.h"
#include "tests/app/temporary_folder.h"

namespace throng::app::contexts_test {
namespace {

using testing::HasSubstr;
using testing::Not;

class Opened final : public render::gl::Context {
 public:
  explicit Opened(const char* kind) : kind_(kind) {}
  const char* kind() const override { return kind_; }

 private:
  const char* kind_;
};

/// Makes contexts of which some open.
struct Machine {
  bool window = false, egl = false, osmesa = false;

  ContextMakers makers() const {
    const auto make = [](bool opens, const char* kind) {
      return [opens, kind]() -> MadeContext {
        if (opens) return std::unique_ptr<render::gl::Context>(std::make_unique<Opened>(kind));
        return Error{std::string("no ") + kind};
      };
    };
    return {make(window, "window"), make(egl, "egl"), make(osmesa, "osmesa")};
  }
};

DemoOptions asking_for(ContextKind kind, const char* screenshot = "") {
  DemoOptions options;
  options.context = kind;
  options.screenshot = screenshot;
  return options;
}

std::string kind_of(const MadeContext& made) { return made ? (*made)->kind() : made.error().message; }

std::string opened(const DemoOptions& options, const Machine& machine) {
  return kind_of(open_context(options, machine.makers()));
}

constexpr auto window = ContextKind::window, any = ContextKind::headless_default, egl = ContextKind::egl,
               osmesa = ContextKind::osmesa;

TEST(Contexts, AreOfTheKindThatIsAskedFor) {
  const Machine all{true, true, true};
  EXPECT_EQ(opened(asking_for(window), all), "window");
  EXPECT_EQ(opened(asking_for(any), all), "egl");
  EXPECT_EQ(opened(asking_for(egl), all), "egl");
  EXPECT_EQ(opened(asking_for(osmesa), all), "osmesa");
  EXPECT_EQ(opened(asking_for(any), {.osmesa = true}), "osmesa");
}

TEST(Contexts, ThatDoNotOpenAdviseThoseThatDo) {
  EXPECT_EQ(opened(asking_for(window), {.egl = true}), "no window; use --headless");
  EXPECT_EQ(opened(asking_for(window), {.osmesa = true}), "no window; no egl; use --headless");
  EXPECT_EQ(opened(asking_for(egl), {.osmesa = true}), "no egl; use --headless=osmesa");
  EXPECT_EQ(opened(asking_for(osmesa), {.egl = true}), "no osmesa; use --headless=egl");
}

// Whoever follows an advice meets none that sends back.
TEST(Contexts, NeverAdviseWhatDoesNotOpen) {
  for (const ContextKind kind : {window, any, egl, osmesa}) {
    const std::string told = opened(asking_for(kind, "picture.png"), {});
    EXPECT_THAT(told, Not(HasSubstr("--headless"))) << told;
    EXPECT_THAT(told, HasSubstr("no egl")) << told;
    EXPECT_THAT(told, HasSubstr("no osmesa")) << told;
  }
}

TEST(Contexts, AdviseToDrawNothingOnlyWhereNoPictureIsAskedFor) {
  EXPECT_EQ(opened(asking_for(any), {}), "no egl; no osmesa; --headless=none runs without drawing");
  EXPECT_EQ(opened(asking_for(any, "picture.png"), {}), "no egl; no osmesa");
}

/// Runs the program where both libraries are empty files.
class BrokenLibraries : public test::TemporaryFolder {
 protected:
  void SetUp() override {
    for (const char* name : {"libEGL.so.1", "libOSMesa.so.8"}) std::ofstream(folder_ / name);
    setenv("LD_LIBRARY_PATH", folder_.c_str(), 1);
  }
  void TearDown() override { unsetenv("LD_LIBRARY_PATH"); }
};

TEST_F(BrokenLibraries, AreNotCalledMissing) {
  for (const std::string kind : {"--headless", "--headless=egl", "--headless=osmesa"}) {
    const ProgramRun run = run_program({kind, "--agents", "3", "--draw", "last"});
    EXPECT_EQ(run.exit_status, 1);
    EXPECT_THAT(run.errors, HasSubstr("libEGL.so.1 is installed and cannot be loaded (")) << kind;
    EXPECT_THAT(run.errors, HasSubstr("libOSMesa.so.8 is installed and cannot be loaded (")) << kind;
    EXPECT_THAT(run.errors, HasSubstr("file too short), install libegl1 again")) << kind;
    EXPECT_THAT(run.errors, Not(HasSubstr("--headless"))) << kind;
    EXPECT_EQ(run.errors.find('\n'), run.errors.size() - 1) << run.errors;
  }
}

TEST_F(BrokenLibraries, LeaveTheRunWithoutDrawing) {
  const ProgramRun run = run_program({"--headless=osmesa", "--agents", "3"});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_THAT(run.errors, HasSubstr("; --headless=none runs without drawing\n"));
  EXPECT_EQ(run_program({"--headless=none", "--agents", "3", "--frames", "2"}).exit_status, 0);
}

}  // namespace
}  // namespace throng::app::contexts_test
