#pragma once

#include "app/settings/output_choices.h"

/// Requests of request.h for pictures and videos as files.
namespace throng::app {

/// The picture of the window as a file, with the panel if it is shown.
struct TakeScreenshot {};
/// A picture without the panel as a file, drawn once more in full quality.
struct TakeStill {};
/// A video as a file: of the part of a recorded crowd, or from now on. It is made while the window goes on.
struct MakeVideo {};
/// How large such a picture is, and how long such a video.
struct SetOutput {
  OutputChoices choices;
};

}  // namespace throng::app
