#include "assets/wardrobe/outfit.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

namespace throng::wardrobe {
namespace {

using mannequin::Mesh;
using mannequin::MeshVertex;

std::vector<std::string> split(std::string_view text) {
  std::vector<std::string> words;
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    words.emplace_back(text.substr(0, comma));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return words;
}

/// Programs that know no tints of these regions show them so.
void paint_plainly(MeshVertex& vertex) {
  constexpr std::array<std::array<double, 3>, 3> colours{{{0.05, 0.07, 0.12}, {0.35, 0.06, 0.05}, {0.12, 0.07, 0.04}}};
  const auto region = static_cast<std::size_t>(vertex.region);
  if (region < 6) return;
  for (std::size_t i = 0; i < 3; ++i) {
    vertex.colour[i] = static_cast<std::uint8_t>(std::lround(vertex.colour[i] * colours.at(region - 6).at(i)));
  }
  vertex.region = 5;
}

void append(Mesh& all, const MadePart& made, const Fitted& fitted, const Level& level, bool plain) {
  const std::size_t first = all.vertices.size();
  for (std::size_t v = 0; v < fitted.positions.size(); ++v) {
    MeshVertex vertex = made.mesh.vertices[v];
    vertex.position = fitted.positions[v];
    vertex.normal = fitted.normals[v];
    vertex.colour = fitted.colours[v];
    vertex.piece = static_cast<unsigned char>(made.slot);
    if (plain) paint_plainly(vertex);
    all.vertices.push_back(vertex);
  }
  const auto moved = [&](std::size_t i) { return static_cast<std::uint16_t>(first + level.indices[i]); };
  for (std::size_t i = 0; i < level.indices.size(); i += 3) {
    all.triangles.push_back({moved(i), moved(i + 1), moved(i + 2)});
  }
}

/// Returns the levels of a part that are seen, whatever is worn over it.
const std::vector<Level>& seen_levels(const MadePart& made, const Outfit& outfit) {
  for (const Below& below : made.below) {
    for (const std::string& name : outfit.parts) {
      const std::vector<std::string>& tags = find_part(name, outfit.body)->tags;
      if (std::ranges::find(tags, below.tag) != tags.end()) return below.levels;
    }
  }
  return made.levels;
}

}  // namespace

std::optional<Outfit> read_outfit(std::string_view text) {
  Outfit outfit;
  std::vector<std::string> words = split(text);
  const auto body = std::find_if(all_bodies.begin(), all_bodies.end(),
                                 [&](Body b) { return !words.empty() && name_of(b) == words.front(); });
  if (body == all_bodies.end()) {
    std::fputs("throng_wardrobe: an outfit begins with man, woman or child\n", stderr);
    return std::nullopt;
  }
  outfit.body = *body;
  outfit.parts.assign(words.begin() + 1, words.end());
  for (const std::string& name : outfit.parts) {
    if (find_part(name, outfit.body) != nullptr) continue;
    std::fprintf(stderr, "throng_wardrobe: there is no %s for a %s\n", name.c_str(), words.front().c_str());
    return std::nullopt;
  }
  return outfit;
}

Mesh dressed(const Outfit& outfit, const std::vector<Finished>& parts, std::size_t level, bool plain) {
  std::set<Slot> covered;
  const auto worn = [&](const Finished& finished) {
    if (finished.made->part == nullptr) return true;
    return fits(finished.made->part->bodies, outfit.body) &&
           std::find(outfit.parts.begin(), outfit.parts.end(), finished.made->name) != outfit.parts.end();
  };
  for (const Finished& finished : parts) {
    if (!worn(finished) || finished.made->part == nullptr) continue;
    covered.insert(finished.made->part->covers.begin(), finished.made->part->covers.end());
  }
  Mesh all;
  for (const Finished& finished : parts) {
    if (!worn(finished) || covered.contains(finished.made->slot)) continue;
    const std::vector<Level>& levels = seen_levels(*finished.made, outfit);
    for (const Fitted& fitted : finished.bodies) {
      if (fitted.body != outfit.body) continue;
      append(all, *finished.made, fitted, levels[std::min(level, levels.size() - 1)], plain);
    }
  }
  return all;
}

}  // namespace throng::wardrobe
