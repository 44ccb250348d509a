// A thousand people in a renderer of one's own, without a display: plain OpenGL 4.5, with throng::crowd alone.
#include "own_opengl.h"

#include <bit>
#include <cmath>
#include <cstdio>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "throng/crowd_view.h"
#include "throng/throng.h"

using namespace throng;

namespace {

/// Palette pages that PUs write and the device reads.
struct MappedPages final : render::PalettePageSource {
  std::vector<GLuint> buffers;
  render::PalettePage add_page() override {
    constexpr std::size_t bytes = std::size_t{16} << 20U;
    constexpr GLbitfield flags = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    glCreateBuffers(1, &buffers.emplace_back());
    glNamedBufferStorage(buffers.back(), bytes, nullptr, flags);
    return {static_cast<std::byte*>(glMapNamedBufferRange(buffers.back(), 0, bytes, flags)), bytes};
  }
};

/// Makes a vertex array of a mesh: positions, normals, palette entries and weights, each in a buffer of its own.
GLuint array_of(const MeshView& mesh) {
  GLuint array = 0;
  glCreateVertexArrays(1, &array);
  const auto add = [&](GLuint place, const auto& data, GLint size, GLenum type) {
    glVertexArrayVertexBuffer(array, place, buffer_of(data), 0, sizeof(data.front()));
    glEnableVertexArrayAttrib(array, place);
    glVertexArrayAttribBinding(array, place, place);
    if (type == GL_FLOAT) glVertexArrayAttribFormat(array, place, size, type, GL_FALSE, 0);
    if (type != GL_FLOAT) glVertexArrayAttribIFormat(array, place, size, type, 0);
  };
  add(0, mesh.positions, 3, GL_FLOAT);
  add(1, mesh.normals, 3, GL_FLOAT);
  add(2, mesh.palette_entries, 4, GL_UNSIGNED_SHORT);
  add(3, mesh.weights, 4, GL_FLOAT);
  glVertexArrayElementBuffer(array, buffer_of(mesh.indices));
  return array;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) return std::fprintf(stderr, "usage: own_opengl MODEL PICTURE.png\n"), 2;
  const auto file = load(arguments[1], {.keep_meshes = true});
  if (!file) return std::fprintf(stderr, "%s\n", file.error().message.c_str()), 1;
  const Character& person = file->characters.front();
  auto crowd = Crowd::create(person, {.pus = 2});
  if (!crowd || !open_context()) return std::fprintf(stderr, "there is no crowd, or no OpenGL 4.5\n"), 1;

  MappedPages pages;
  CrowdView view(pages);
  std::vector<Vec3> positions;
  std::vector<Heading> headings;
  for (const AgentId agent : crowd->add_agents(1000)) {
    const std::uint32_t i = agent.number;
    crowd->agent(agent).play(
        {.clip = person.find_role(i % 3 == 0 ? "wave" : "walk"), .start = ticks_per_second * (i % 60) / 60});
    positions.push_back({1.7F * (static_cast<float>(i % 25) - 12.0F), 0.0F, -1.9F * static_cast<float>(i / 25)});
    headings.push_back({std::cos(static_cast<float>(i)), std::sin(static_cast<float>(i))});
  }
  const glm::vec3 eye(0.0F, 3.2F, 9.0F), forward(0.0F, -0.16F, -0.987F);
  const glm::mat4 seen = glm::lookAt(eye, eye + forward, glm::vec3(0.0F, 1.0F, 0.0F));
  const glm::mat4 projection = glm::perspective(0.87F, float{width} / float{height}, 0.1F, 500.0F);
  ViewFrame frame{.positions = positions, .headings = headings, .frame_step = ticks_per_second / 60};
  frame.view = std::bit_cast<Mat4>(seen);
  frame.projection = std::bit_cast<Mat4>(projection);
  const Mat4 clip_from_world = std::bit_cast<Mat4>(projection * seen);
  frame.camera = camera_of(std::bit_cast<Vec3>(eye), std::bit_cast<Vec3>(forward), clip_from_world, height);
  CrowdDraws draws;
  for (int i = 0; i < 60; ++i) {
    crowd->advance(frame.frame_step);
    frame.completed = view.frame();  // no frame before the last is drawn; a window asks its fences
    view.choose(*crowd, frame);
    view.pose(*crowd);
    draws = view.draws(*crowd);
  }

  std::vector<std::uint32_t> entry_at_level;
  for (int level = 0; level < person.level_count(); ++level) {
    for (const std::uint16_t entry : person.entries_at_level(level)) entry_at_level.push_back(entry);
  }
  begin_picture();
  glUniformMatrix4fv(0, 1, GL_FALSE, &clip_from_world.columns[0][0]);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer_of(draws.instances));
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, buffer_of(std::span<const std::uint32_t>(entry_at_level)));
  for (std::size_t part = 0; part < person.mesh_count(); ++part) {
    glBindVertexArray(array_of(person.mesh(part)));
    for (const render::CrowdBatch& batch : draws.batches) {
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, pages.buffers[batch.page]);
      glUniform3ui(1, batch.first, draws.now, person.palette_entries());
      glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(person.mesh(part).indices.size()), GL_UNSIGNED_INT,
                              nullptr, static_cast<GLsizei>(batch.count));
    }
  }
  if (!write_picture(arguments[2])) return std::fprintf(stderr, "%s cannot be written\n", arguments[2]), 1;
  std::printf("drew %u people in %zu draws a mesh, %u posed in the last frame\n", view.figures().agents_in_view,
              draws.batches.size(), view.figures().agents_posed);
}
