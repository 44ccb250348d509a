// Times a picture on the processor before it is drawn: composing records, and choosing who casts shadows.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "throng/heap_pages.h"

#include "app/commands/bench/report.h"
#include "app/commands/bench/rounds.h"
#include "app/show/camera/fly_camera.h"
#include "app/show/camera/scenes.h"
#include "app/show/picture.h"
#include "app/show/stage/stage.h"
#include "engine/base/files/cores.h"
#include "engine/render/passes/casters.h"
#include "tests/benchmark/programs/program.h"

namespace throng::app {
namespace {

constexpr const char* character_file = THRONG_SOURCE_DIR "/assets/mannequin.glb";
constexpr int width = 1280, height = 720, map_side = 2048;
constexpr float reach = 1.3F;  // metres of the built-in character's surface from where it stands
constexpr render::MeshError mesh_errors[] = {{},          {0.003F, 0}, {0.009F, 0}, {0.022F, 0},
                                             {0.042F, 0}, {0.067F, 0}, {0.11F, 0}};  // shares of its height
constexpr std::array<bool, render::cascade_count> all_cascades{true, true, true, true};

/// A crowd on the plaza, and all that its picture is made of.
class Subject {
 public:
  static Result<std::unique_ptr<Subject>> create(int agents) {
    auto character = load_character(character_file, "mannequin");
    if (!character) return character.error();
    std::unique_ptr<Subject> subject(new Subject());
    subject->tuning_.agents = agents;
    std::vector<CharacterSource> characters;
    characters.push_back(std::move(*character));
    auto stage = Stage::create(std::move(characters), subject->tuning_, subject->pages_);
    if (!stage) return stage.error();
    subject->stage_ = std::move(*stage);
    subject->stage_->posed().mesh_lods().set(0, std::vector(std::begin(mesh_errors), std::end(mesh_errors)),
                                             std::vector<std::uint32_t>(std::size(mesh_errors), 1000));
    subject->pose();
    return subject;
  }

  void use_pus(int pus) {
    tuning_.system.pus = pus;
    static_cast<void>(stage_->apply(tuning_));
  }
  /// Gives everybody ten pieces of a hundred and one of twelve silhouettes, or takes them off.
  void dress(bool dressed) {
    std::vector<render::Outfit> outfits(stage_->crowd().size());
    for (std::uint32_t agent = 0; dressed && agent < outfits.size(); ++agent) {
      outfits[agent].count = 10;
      for (std::uint32_t i = 0; i < 10; ++i) {
        outfits[agent].pieces.at(i) = static_cast<std::uint16_t>(1 + 10 * i + (agent * 2654435761U >> 3U * i) % 10);
      }
      outfits[agent].silhouette = static_cast<std::uint16_t>(101 + agent % 12);
    }
    const std::vector<render::AgentLook> looks = stage_->crowd().looks().drawn;
    stage_->animated().crowd().looks().wear(looks, std::move(outfits));
    compose();
  }
  void compose() { picture_.compose(*stage_); }
  void choose_casters() {
    render::CrowdFrame frame = this->frame();
    frame.jobs = {.executor = &stage_->system().executor(), .at_once = stage_->system().options().pus};
    reaches_.assign(stage_->characters().size(), reach);
    casters_.choose(frame, reaches_, axes_, render::cast_limits(cascades_, axes_, all_cascades));
  }
  /// Does the same in the plain way: a pass over all instances for each cascade, on one thread.
  void choose_casters_plainly() {
    plain_casters_.clear();
    for (const render::Cascade& cascade : cascades_) {
      const render::CastLimits limits = render::cast_limits({cascade}, axes_, {true});
      for (std::uint32_t i = 0; i < picture_.instances().size(); ++i) {
        if (casts_into_first(limits, picture_.instances()[i])) plain_casters_.push_back(i);
      }
    }
  }
  bool casters_are_the_same() const { return std::ranges::equal(casters_.all(), plain_casters_); }
  std::size_t in_view() const { return picture_.instances().size(); }
  std::size_t casters() const { return casters_.all().size(); }

 private:
  Subject() = default;

  void pose() {
    const auto cameras = scene_cameras(Scene::plaza, stage_->crowd().size(), stage_->characters()[0].roles);
    const render::Camera camera = camera_at(cameras.front().place);
    view_ = render::view_of(camera, static_cast<float>(width) / height);
    stage_->move(ticks_per_second / 60);
    stage_->pose(camera, width, height, ticks_per_second / 60, 0);
    compose();
    axes_ = render::sun_axes(render::to_brightest(tuning_.light));
    cascades_ = render::plan_cascades(view_, axes_, render::depths_of(frame()), map_side);
  }
  render::CrowdFrame frame() const {
    return {.camera = view_,
            .instances = picture_.instances(),
            .batches = picture_.batches(),
            .drawn = picture_.drawn(),
            .runs = picture_.runs()};
  }
  bool casts_into_first(const render::CastLimits& limits, const render::InstanceRecord& record) const {
    const glm::vec3 place(record.position[0], record.position[1], record.position[2]);
    const glm::vec3 from_middle = axes_.along(place) - glm::vec3(limits.x[0], limits.y[0], limits.z[0]);
    const float radius = limits.reach[0] + reach * record.scale;
    return std::abs(from_middle.x) < radius && std::abs(from_middle.y) < radius && from_middle.z > -radius;
  }

  Tuning tuning_{.scene = Scene::plaza, .system = {.pus = 1}};
  HeapPageSource pages_{std::size_t{16} << 20U};
  std::unique_ptr<Stage> stage_;
  render::CameraView view_;
  Picture picture_;
  render::SunAxes axes_{};
  std::array<render::Cascade, render::cascade_count> cascades_{};
  std::vector<float> reaches_;
  render::Casters casters_;
  std::vector<std::uint32_t> plain_casters_;
};

Result<Json> measure_crowd(int agents, int pus, int frames) {
  auto made = Subject::create(agents);
  if (!made) return made.error();
  Subject& subject = **made;
  const auto one = [&] { subject.use_pus(1), subject.dress(false); };
  const auto all = [&] { subject.use_pus(pus), subject.dress(false); };
  const auto one_dressed = [&] { subject.use_pus(1), subject.dress(true); };
  const auto all_dressed = [&] { subject.use_pus(pus), subject.dress(true); };
  BenchRounds rounds;
  rounds.add({"compose_1", [&] { subject.compose(); }, one});
  rounds.add({"compose", [&] { subject.compose(); }, all});
  rounds.add({"compose_dressed_1", [&] { subject.compose(); }, one_dressed});
  rounds.add({"compose_dressed", [&] { subject.compose(); }, all_dressed});
  rounds.add({"casters_dressed_1", [&] { subject.choose_casters(); }, one_dressed});
  rounds.add({"casters_dressed", [&] { subject.choose_casters(); }, all_dressed});
  rounds.add({"casters_plainly", [&] { subject.choose_casters_plainly(); }, all});
  rounds.add({"casters_1", [&] { subject.choose_casters(); }, one});
  rounds.add({"casters", [&] { subject.choose_casters(); }, all});
  rounds.run(frames, std::to_string(agents) + " agents: ");
  if (!subject.casters_are_the_same()) return Error{"two ways to choose casters differ"};
  constexpr double nanoseconds_a_millisecond = 1e6;
  Json row = {{"agents", agents}, {"agents_in_view", subject.in_view()}, {"casters", subject.casters()}};
  for (const char* const key : {"compose_1", "compose", "compose_dressed_1", "compose_dressed", "casters_plainly",
                                "casters_1", "casters", "casters_dressed_1", "casters_dressed"}) {
    row[std::string(key) + "_ms_median"] = rounds.times().median(key) / nanoseconds_a_millisecond;
  }
  return row;
}

Result<BenchReport> measure_pictures(const BenchOptions& options) {
  std::vector<Json> rows;
  for (const int agents : options.agents) {
    const int pus = options.pus.front() > 0 ? options.pus.front() : usable_cores();
    auto row = measure_crowd(agents, pus, options.frames);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  constexpr std::array columns = {"agents",
                                  "agents_in_view",
                                  "casters",
                                  "compose_1_ms_median",
                                  "compose_ms_median",
                                  "compose_dressed_1_ms_median",
                                  "compose_dressed_ms_median",
                                  "casters_plainly_ms_median",
                                  "casters_1_ms_median",
                                  "casters_ms_median",
                                  "casters_dressed_1_ms_median",
                                  "casters_dressed_ms_median"};
  return BenchReport{.text = figures_as_text(rows, columns), .json = figures_as_json(rows), .plot = {}};
}

}  // namespace
}  // namespace throng::app

int main(int argument_count, char** arguments) {
  return throng::app::run_bench_program(argument_count, arguments, throng::app::measure_pictures);
}
