#pragma once

#include "app/settings/settings.h"
#include "app/show/show_parts.h"
#include "app/show/starting_characters.h"
#include "engine/base/result.h"
#include "engine/tracks/track_clock.h"

/// Where a show begins: the moment of a recorded crowd, and the camera.
namespace throng::app {

/// Returns the clock with which a recorded crowd begins. Errors: its file has no such time.
Result<TrackClock> first_clock(const Trajectories& tracks, const TrajectoryOptions& asked, bool repeats_unasked);

/// Takes the recorded crowd of a show, if it has one, to the part and the moment that the options name. Returns false
/// and sets the error where its file has no such time.
bool begin_tracks(Stage& stage, const DemoOptions& options, StartError& error);

/// Puts the camera where the options say, with what moves it from there. Returns false and sets the error where the
/// crowd has no such camera or person, or the file of a path cannot be read.
bool place_camera(ShowParts& show, const DemoOptions& options, StartError& error);

}  // namespace throng::app
