#pragma once

#include <functional>
#include <string>

#include <glm/vec2.hpp>

#include "app/settings/settings.h"
#include "engine/base/result.h"

namespace throng::app {

class Show;

/// Writes the picture that was drawn last as a PNG that says what drew it. Errors: it is not whole, or the file cannot
/// be written.
Status write_picture(Show& show, const std::string& file);

/// Returns the pixels of a still that has so many times the width and height of a show's window.
glm::ivec2 size_of_still(Show& show, int times);

/// Writes the moment that a show shows as a PNG of that size, without a panel, as `--headless --screenshot` would with
/// these values. `draw_over` draws over the picture. No time passes. The window's picture is as before, and is to be
/// drawn anew. Poses of a replay stay as they were recorded. Errors: the picture is too large, or cannot be drawn or
/// written; those of `draw_over`.
Status write_still(Show& show, const std::string& file, glm::ivec2 size, const Tuning& values, bool is_replay,
                   const std::function<Status(Show&)>& draw_over);

}  // namespace throng::app
