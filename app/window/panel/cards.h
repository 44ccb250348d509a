#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/show/camera/input.h"
#include "app/show/report/frame_report.h"
#include "app/show/request/requests.h"
#include "app/window/panel/controls/widgets.h"
#include "app/window/panel/selected_name.h"

namespace throng::app {

struct TabContext;

/// The reason why an agent cannot be pushed over.
inline constexpr const char* cannot_fall = "it has fallen already, or its body is not known well enough";

/// Shows the strip below the crowd: the cost of the last frame, and of the frames before it. A click at one of these
/// looks at it.
void show_frame_strip(Widgets& widgets, const Area& place, const FrameReport& report, Requests& requests);

/// Shows the keys and explains every word of the panel, or only the entries with the letters of `searched`, which the
/// edits there. Returns whether the person closed the card.
bool show_help_card(Widgets& widgets, const Area& crowd, std::string& searched);

/// Shows at the top of the crowd how far each job is, with a button that cancels it. Returns the y where other things
/// over the crowd begin.
float show_jobs(Widgets& widgets, const Area& crowd, const std::vector<JobReport>& jobs, Requests& requests);

/// Fills a window with the name of the program and the job that its start is.
void show_start_card(Widgets& widgets, const Area& window, const JobReport& job, Requests& requests);

/// Shows the messages so far, the newest first. Returns whether the person closed the card.
bool show_log_card(Widgets& widgets, const Area& crowd, const Messages& messages);

enum class CardAnswer : std::uint8_t { none, fold, close_all };

/// Shows warnings that came together, in the upper left of `place`, with a button that closes all of them.
CardAnswer show_remarks_card(Widgets& widgets, const Area& place, std::span<const std::string> remarks);

/// Shows what the selected agent, which there is, does, and the end of the graph of entities that makes its pose, as
/// far as there is room; of a person of a recorded crowd, speed and steps over time. The card begins in the upper left
/// of `place`, where there is mostly sky. Closing it deselects the agent.
void show_selection_card(Widgets& widgets, const Area& place, const FrameReport& report, Requests& requests);

/// Shows the button *View*, which asks for the selected agent's character alone, in the clip that it plays. `name`
/// tells it apart in the map.
void show_view_button(Widgets& widgets, const std::string& name, float width, Requests& requests);

/// Returns the way in which an agent is pushed that is seen from a camera.
glm::vec3 ahead_of(const CameraPose& camera);

/// Returns the seconds of a player in its clip, such as "0.42 / 1.03"; nothing for other entities.
std::string place_in_clip(const EntityRow& row);

/// Shows a replay's place and outcome at the foot of the crowd, with its controls: play and pause, a frame back and on,
/// a track over all frames, loop, speed.
void show_replay_bar(Widgets& widgets, const Area& crowd, const ReplayReport& replay, Requests& requests);

/// Carries out the keys pressed in this frame for a replay: Space pauses, Left and Right go a frame back and on.
void apply_replay_keys(const InputFrame& input, Requests& requests);

/// Shows the timeline of a recorded crowd at the foot of the crowd: how many people are there over the file's time,
/// with a handle at the present time and one at each end of the part that is played. Below, its controls: a row back,
/// play backwards, play and pause, a row on, rate, loop, the whole file.
void show_track_bar(const TabContext& context, const Area& crowd);
/// Returns the height that it takes at the foot of the crowd, with the margin below it.
float height_of_track_bar(const Theme& theme);

/// Carries out the keys pressed in this frame for a recorded crowd: Left and Right go a row back and on, with Shift a
/// second, and pause; `[` and `]` begin and end the part that is played; Shift+Space plays the other way; Space at the
/// end begins anew. The caller handles Space as the pause before.
void apply_track_keys(const InputFrame& input, const TracksReport& tracks, Tuning& tuning, Requests& requests);

/// The answers to the question what becomes of unsaved work.
enum class UnsavedAnswer : std::uint8_t { save, leave, stay };

/// Asks, before something is closed or opened, what becomes of unsaved work. Buttons and the keys S, L and Esc answer.
/// Returns the answer once there is one.
std::optional<UnsavedAnswer> show_question_card(Widgets& widgets, const InputFrame& input,
                                                const UnsavedReport& unsaved);

/// Begins a window of the overlay that stays in its place; end it with ImGui::End().
void begin_fixed_window(const char* name, const Area& place, float rounding = 0, ImGuiWindowFlags more_flags = 0);

/// The margin around a bar at the foot of the crowd, in pixels of a plain screen.
inline constexpr float bar_margin = 12;

/// Begins a bar of that height at the foot of the crowd; end it with ImGui::End(). Returns its place.
Area begin_bar(Widgets& widgets, const char* name, const Area& crowd, float height);

/// Begins a window that lets the pointer through, for words over the crowd; end it with ImGui::End().
void begin_clear_window(const char* name, const Area& place);

}  // namespace throng::app
