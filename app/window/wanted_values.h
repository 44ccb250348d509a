#pragma once

namespace throng::app {

struct WindowSession;

/// Gives the show the values for the next frame: those of the exact crowd while a person holds its key, the next stop
/// of a sweep, or the values that the person asks for.
void show_wanted_values(WindowSession& session, bool exact_crowd);

/// Adds the cost of the frame that was animated last to the sweep that runs, and reports the sweep.
void measure_for_sweep(WindowSession& session);

}  // namespace throng::app
