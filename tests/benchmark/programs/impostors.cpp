// How far off an impostor would be, beside the far meshes: throng_impostors [MODEL].
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "app/character/source.h"
#include "engine/anim/asset/reference_pose.h"
#include "engine/render/mesh/packed_surface.h"

namespace throng::app {
namespace {

constexpr std::array gaits{Role::walk, Role::jog, Role::run};
constexpr std::array heights{12.0, 20.0, 30.0};                     // pixels
constexpr double full_turn = 6.283185307179586, steepest = 1.0472;  // 60 degrees, from which a crowd is looked at
constexpr int looks = 300;                                          // at each gait
constexpr std::size_t most_points = 250;
constexpr double bytes_of_cell = 32.0 * 32.0 * 8.0;  // 30 pixels tall; colour, normal, depth, region

/// The directions to the right and up in a picture.
struct View {
  View(double around, double above)
      : right(std::cos(around), 0.0, -std::sin(around)),
        up(-std::sin(around) * std::sin(above), std::cos(above), -std::cos(around) * std::sin(above)) {}
  glm::dvec2 seen(const glm::dvec3& point) const { return {glm::dot(right, point), glm::dot(up, point)}; }
  glm::dvec3 right, up;
};

struct Atlas {
  int views, elevations, poses;
};

/// Points of a surface, in metres from their middle, because clips may walk away.
class Figure {
 public:
  explicit Figure(const CharacterSource& source) : source_(source), data_(mesh_data(source)) {
    std::size_t vertices = 0;
    for (const render::MeshPartData& part : data_.parts) vertices += part.weights.size() / 4;
    stride_ = vertices / most_points + 1;
  }

  double height() const { return source_.character->bounds.height; }
  const render::CrowdMeshData& data() const { return data_; }

  std::vector<glm::dvec3> points(const anim::Clip& clip, double seconds) const {
    const std::vector<glm::dmat4> palette = anim::reference_pose(source_.model.skeleton, &clip, seconds).palette;
    std::vector<glm::dvec3> found;
    for (const render::MeshPartData& part : data_.parts) {
      for (std::size_t vertex = 0; vertex < part.weights.size() / 4; vertex += stride_) {
        const glm::dvec4 rest(part.positions[vertex * 3], part.positions[vertex * 3 + 1],
                              part.positions[vertex * 3 + 2], 1.0);
        glm::dvec3 place(0.0);
        for (std::size_t i = vertex * 4; i < vertex * 4 + 4; ++i) {
          place += static_cast<double>(part.weights[i]) * glm::dvec3(palette[part.palette_entries[i]] * rest);
        }
        found.push_back(place);
      }
    }
    glm::dvec3 middle(0.0);
    for (const glm::dvec3& place : found) middle += place / static_cast<double>(found.size());
    for (glm::dvec3& place : found) place -= middle;
    return found;
  }

 private:
  const CharacterSource& source_;
  render::CrowdMeshData data_;
  std::size_t stride_ = 1;
};

double nearest(double value, double step, double first) { return first + std::round((value - first) / step) * step; }

/// Returns how far points are from where the impostor shows them, in shares of the height, ascending.
std::vector<double> errors_of(const Figure& figure, std::span<const anim::Clip* const> clips, const Atlas& atlas) {
  std::vector<double> errors;
  for (const anim::Clip* clip : clips) {
    for (int look = 0; look < looks; ++look) {  // evenly spread
      const auto share = [look](double step) { return std::fmod(0.5 + step * look, 1.0); };
      const double around = share(0.8191725) * full_turn, above = share(0.6710436) * steepest;
      const double seconds = share(0.5497005) * clip->length();
      const double band = steepest / atlas.elevations, baked_above = (std::floor(above / band) + 0.5) * band;
      const View now(around, above), baked(nearest(around, full_turn / atlas.views, 0.0), baked_above);
      const auto here = figure.points(*clip, clip->start + seconds);
      const auto there = figure.points(
          *clip, clip->start + std::fmod(nearest(seconds, clip->length() / atlas.poses, 0.0), clip->length()));
      for (std::size_t i = 0; i < here.size(); ++i) {
        errors.push_back(glm::distance(now.seen(here[i]), baked.seen(there[i])) / figure.height());
      }
    }
  }
  std::ranges::sort(errors);
  return errors;
}

void print_row(const std::string& what, double bytes, double usual, double largest) {
  std::printf("%-40s %10.0f KB", what.c_str(), bytes / 1000.0);
  for (const double height : heights) std::printf("   %5.2f  %5.2f", usual * height, largest * height);
  std::printf("\n");
}

int run(const std::string& model) {
  const auto source = load_character(model, "figure");
  if (!source) return std::fprintf(stderr, "%s\n", source.error().message.c_str()), 1;
  std::vector<const anim::Clip*> clips;
  for (const Role gait : gaits) {
    if (const int clip = source->roles.clip(gait); clip >= 0) {
      clips.push_back(&source->model.clips[static_cast<std::size_t>(clip)]);
    }
  }
  const Figure figure(*source);
  std::printf("pixels of error, 95%% of points and the largest, at 12, 20 and 30 pixels tall; %zu clips\n",
              clips.size());
  for (const int views : {8, 16, 32}) {
    for (const int elevations : {2, 4}) {
      for (const int poses : {8, 16, 32}) {
        const std::vector<double> errors = errors_of(figure, clips, {views, elevations, poses});
        const double cells = static_cast<double>(views * elevations * poses) * static_cast<double>(clips.size());
        print_row("impostor " + std::to_string(views) + " x " + std::to_string(elevations) + " views, " +
                      std::to_string(poses) + " poses a clip",
                  cells * bytes_of_cell, errors[errors.size() * 95 / 100], errors.back());
      }
    }
  }
  const auto surface = render::surface_parts(figure.data());
  if (!surface) return 1;
  const render::SurfacePiece& whole = surface->pieces[0];
  for (std::size_t lod = 0; lod < whole.error_by_level.size(); ++lod) {
    const double share = static_cast<double>(whole.error_by_level[lod].surface) / figure.height();
    const std::uint32_t triangles = whole.triangles_by_level[lod];
    print_row("mesh of " + std::to_string(triangles) + " triangles", triangles * 12.0, share, share);
  }
  return 0;
}

}  // namespace
}  // namespace throng::app

int main(int argc, char** argv) {
  return throng::app::run(argc > 1 ? argv[1] : THRONG_SOURCE_DIR "/assets/mannequin.glb");
}
