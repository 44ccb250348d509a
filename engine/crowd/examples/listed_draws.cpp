// What a renderer of any API is given for a frame of a crowd: palettes in memory, instances, and a handful of draws,
// which this program prints.
#include <cmath>
#include <cstdio>
#include <vector>

#include "throng/crowd_view.h"
#include "throng/heap_pages.h"
#include "throng/throng.h"

using namespace throng;

int main(int count, char** arguments) {
  if (count != 2) return std::fprintf(stderr, "usage: listed_draws MODEL\n"), 2;
  const auto file = load(arguments[1]);
  if (!file) return std::fprintf(stderr, "%s\n", file.error().message.c_str()), 1;
  const Character& person = file->characters.front();
  auto crowd = Crowd::create(person, {.pus = 2});
  if (!crowd) return std::fprintf(stderr, "%s\n", crowd.error().message.c_str()), 1;

  // A device of your own gives its mapped memory here: derive from render::PalettePageSource.
  HeapPageSource pages(std::size_t{16} << 20U);
  CrowdView view(pages);
  // Your simplifier says how far each of its meshes is off, and counts triangles; render::Renderer says it too.
  const render::MeshError errors[] = {{}, {0.004F, 0.002F}, {0.02F, 0.01F}};
  const std::uint32_t triangles[] = {12'000, 4'000, 900};
  if (const auto set = view.set_mesh_lods(0, {errors, triangles}); !set) return 1;

  std::vector<Vec3> positions;
  for (const AgentId agent : crowd->add_agents(1000)) {
    crowd->agent(agent).play({.clip = {agent.number % person.clip_count()}});
    positions.push_back(
        {2.0F * static_cast<float>(agent.number % 25), 0.0F, 2.0F * static_cast<float>(agent.number / 25)});
  }
  ViewFrame frame{.positions = positions, .frame_step = ticks_per_second / 60};  // with matrices it measures errors
  frame.camera = {.position = {25.0F, 1.7F, -4.0F}, .forward = {0.0F, 0.0F, 1.0F}, .pixels_per_unit = 770.0F};
  CrowdDraws draws;
  for (int i = 0; i < 60; ++i) {
    crowd->advance(frame.frame_step);
    frame.completed = view.frame();  // plain memory is read at once
    view.choose(*crowd, frame);
    view.pose(*crowd);
    draws = view.draws(*crowd);
  }
  for (const render::CrowdBatch& batch : draws.batches) {
    std::printf("draw %4u instances from %4u on: page %u, character %d, mesh %d\n", batch.count, batch.first,
                batch.page, batch.character, batch.mesh_lod);
  }
  const render::InstanceRecord& first = draws.instances.front();
  const float shown = static_cast<float>(draws.now - first.blend_start) / static_cast<float>(first.blend_duration);
  std::printf("agent %u shows the palettes at lines %u and %u, %.0f%% of the second\n", first.agent, first.palette_from,
              first.palette_to,
              first.blend_duration == 0 ? 100.0 : 100.0 * static_cast<double>(std::fmin(shown, 1.0F)));
  std::printf("%u agents in view, %u posed in the last frame\n", view.figures().agents_in_view,
              view.figures().agents_posed);
}
