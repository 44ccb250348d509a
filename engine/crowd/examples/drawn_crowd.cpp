// A thousand people in the sun, drawn by throng::render without a display. Far people are posed more seldom, blended in
// between, and have fewer triangles.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include "throng/crowd_view.h"
#include "throng/drawing.h"
#include "throng/render/camera.h"
#include "throng/render/renderer.h"
#include "throng/throng.h"

using namespace throng;

namespace {

constexpr std::uint32_t people = 1000;
constexpr Ticks frame_time = ticks_per_second / 60;

/// Returns what a call made, or ends the program with its error.
template <typename Value>
Value made(Result<Value> result) {
  if (result) return std::move(*result);
  std::fprintf(stderr, "drawn_crowd: %s\n", result.error().message.c_str());
  std::exit(1);
}

/// Where people are, by the number of their agents.
struct People {
  std::vector<Vec3> positions = std::vector<Vec3>(people);
  std::vector<Heading> headings = std::vector<Heading>(people);
  std::vector<render::AgentLook> looks = std::vector<render::AgentLook>(people, render::plain_look());
};

/// Places people side by side. Each walks its own way, in a shirt of its own.
void place(People& all, std::uint32_t i) {
  constexpr std::array<std::uint32_t, 5> shirts{0xb46e3c, 0x64a54a, 0x4250b8, 0x4ab4d9, 0x948a8a};  // blue, green, red
  const auto row = static_cast<float>(i / 25U), column = static_cast<float>(i % 25U);
  const float turn = 0.7F * std::sin(static_cast<float>(i) * 2.4F);
  all.positions[i] = {1.7F * (column - 12.0F) + std::sin(static_cast<float>(i)), 0.0F, -1.9F * row};
  all.headings[i] = {std::cos(turn), std::sin(turn)};
  const auto color = [&](render::Region region, std::uint32_t blue_green_red) {
    all.looks[i].tints[render::index_of(region)] = render::tint_of(blue_green_red);
  };
  color(render::Region::top, shirts[i % shirts.size()]);
  color(render::Region::bottom, i % 3 == 0 ? 0x5a4632 : 0x3c3a38);
  color(render::Region::shoes, 0x202428);
  color(render::Region::skin, i % 4 == 0 ? 0x4a6a94 : 0x9cb4dc);
  color(render::Region::hair, i % 2 == 0 ? 0x182430 : 0x405070);
}

/// Moves a person as its feet did, from its own space to the world's.
void move(People& all, std::uint32_t i, const RootMotion& motion) {
  const Heading& heading = all.headings[i];
  all.positions[i].x += heading.cosine * motion.displacement.x + heading.sine * motion.displacement.z;
  all.positions[i].z += heading.cosine * motion.displacement.z - heading.sine * motion.displacement.x;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) return std::fprintf(stderr, "usage: drawn_crowd MODEL FOLDER_OF_SHADERS PICTURE.png\n"), 2;
  const Character person = made(load(arguments[1], {.keep_meshes = true})).characters.front();
  const auto context = made(render::gl::make_egl_context({.force_software = true}));
  const auto renderer = made(render::Renderer::create(*context, {.data = arguments[2], .size = {640, 360}}));
  const render::CrowdMeshData surface = made(mesh_data(person));
  made(renderer->load_characters({&surface, 1}));

  Crowd crowd = made(Crowd::create(person, {.pus = 2}));
  CrowdView view(renderer->palette_pages());
  made(view.set_mesh_lods(0, renderer->mesh_lods(0)));

  People all;
  const ClipId walk = person.find_role("walk");
  for (const AgentId agent : crowd.add_agents(people)) {
    place(all, agent.number);
    crowd.agent(agent).play({.clip = walk, .start = person.clip(walk).duration * (agent.number * 37 % 100) / 100});
  }

  const render::CameraView eye = render::view_of({.position = {0.0F, 2.4F, 8.0F}, .pitch = -0.1F}, 16.0F / 9.0F);
  ViewFrame frame{.positions = all.positions, .headings = all.headings, .frame_step = frame_time};
  look_from(frame, eye, renderer->size());
  for (int i = 0; i < 60; ++i) {
    crowd.advance(frame_time);
    for (const AgentId agent : crowd.agents()) {
      move(all, agent.number, crowd.agent(agent).motion().displacement(crowd.clock() - frame_time, crowd.clock()));
    }
    frame.completed = renderer->completed_frame(view.frame());
    view.choose(crowd, frame);
    view.pose(crowd);
  }
  const CrowdDraws draws = view.draws(crowd);  // a window draws each frame; this picture is of the last
  render::CrowdFrame drawn = crowd_frame(eye, draws);
  drawn.looks = all.looks;
  drawn.looks_number = render::new_looks_number();
  renderer->draw(drawn);
  renderer->end_frame(view.frame());
  made(renderer->finish());
  made(write_png(renderer->read_image(), arguments[3]));
  const ViewFigures figures = view.figures();
  std::printf("drew %u people in %zu draws with %.1f million triangles\n", figures.agents_in_view, draws.batches.size(),
              static_cast<double>(figures.triangles) / 1e6);
  std::printf("posed %u of them in the last frame; 99%% of errors are below %.2f pixels\n", figures.agents_posed,
              static_cast<double>(figures.error_p99));
}
