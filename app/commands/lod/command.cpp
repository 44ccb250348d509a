#include "app/commands/lod/command.h"

#include <string>
#include <utility>
#include <vector>

#include "throng/render/camera.h"

#include "app/character/built_in.h"
#include "app/commands/lod/curve.h"
#include "app/files/exit_status.h"
#include "app/show/lod/tuned_view.h"
#include "app/show/stage/stage.h"
#include "engine/base/files/output_file.h"
#include "engine/render/mesh/packed_surface.h"

namespace throng::app {
namespace {

constexpr float exported_height = 720.0F;  // pixels of the picture that distances are for

Result<CharacterSource> character_of(const LodOptions& options) {
  if (options.model.empty()) return load_built_in(options.data);
  const BoneLodFile kept(options.model);
  return load_character(options.model, options.model, &kept, {.import = options.reading});
}

// Exports by the values that a crowd begins with.
std::string exported(const CharacterSource& source, const LodCurve& curve) {
  const Tuning tuning;
  return lod_as_json(source, curve.bones, curve.meshes,
                     {.tuning = tuning,
                      .character = lod_character(source),
                      .tolerance_pixels = pose_error_limit(tuning),
                      .pixels_per_unit = render::pixels_tall({}, exported_height, 1.0F, 1.0F)});
}

Status write_files(const LodOptions& options, const CharacterSource& source, const LodCurve& curve) {
  std::vector<std::pair<std::string, std::string>> files;
  if (!options.json.empty()) files.emplace_back(options.json, curve_as_json(source, curve, options.pixels));
  if (!options.plot.empty()) files.emplace_back(options.plot, curve_as_svg(source, curve, options.pixels));
  if (!options.export_file.empty()) files.emplace_back(options.export_file, exported(source, curve));
  for (const auto& [file, text] : files) {
    if (Status written = write_output(file, text); !written) return written;
  }
  return Done{};
}

Status measure_levels(const LodOptions& options) {
  const auto source = character_of(options);
  if (!source) return source.error();
  LodCurve curve{.bones = lod_levels(*source), .meshes = {}};
  if (source->has_surface()) {
    const auto surface = render::surface_parts(mesh_data(*source));
    if (!surface) return surface.error();
    curve.meshes = mesh_levels(surface->pieces[0].triangles_by_level, surface->pieces[0].error_by_level);
  }
  if (Status timed = time_levels(*source, curve.bones); !timed) return timed;
  Status written = options.json == "-" ? Done{} : print(curve_as_text(*source, curve, options.pixels));
  return written ? write_files(options, *source, curve) : written;
}

}  // namespace

int run_lod(const LodOptions& options) { return end_with(measure_levels(options)); }

}  // namespace throng::app
