#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/window/panel/cards.h"
#include "app/window/panel/controls/card.h"

namespace throng::app {
namespace {

struct HelpLine {
  const char* word;
  const char* meaning;
};

struct HelpChapter {
  const char* title;
  std::span<const HelpLine> lines;
};

constexpr std::array key_lines = std::to_array<HelpLine>({
    {"W A S D", "Fly; Q and E down and up."},
    {"Right drag", "Look around."},
    {"Middle drag", "Turn about the selected character, or about the crowd; Alt and left drag too."},
    {"Wheel", "Flying speed; Shift is faster, Ctrl slower."},
    {"Click", "Select a character; P pushes it over."},
    {"F", "Frame the crowd beside the panel."},
    {"Home", "Back to the scene's camera; a film has the camera again."},
    {"G", "Follow the selected character; again: no longer. With Shift: from behind, turning with it."},
    {"1 to 9", "Go to a place of the camera; Ctrl with it keeps the place."},
    {"X", "While held: the exact crowd, nothing skipped."},
    {"B", "Bring the other of two tunings into use."},
    {"Ctrl+Z, +Y", "Take back the last change of a value; make it again."},
    {"Space", "Pause."},
    {"Left, Right", "In a replay: a frame back, a frame on. In the scene tracks: a row; with Shift, a second."},
    {"Shift+Space", "In the scene tracks: play the other way."},
    {"[, ]", "In the scene tracks: the part that is played begins here, ends here."},
    {"C", "Copy the camera as an option."},
    {"/, Ctrl+F", "Search all values; Enter goes to the only one found."},
    {"Tab", "Hide or show the overlay."},
    {"F6", "Move the keyboard into the panel; again, or Esc: give it back."},
    {"Arrows", "In the panel: up and down go from widget to widget, left and right change a value; Shift: ten steps."},
    {"Enter, Space", "In the panel: press, flip, open a list, type a number. Delete resets a value."},
    {"Ctrl+Page", "Up, Down: the tab before and after."},
    {"R", "Begin a recording; again, end it."},
    {"L", "Messages so far."},
    {"F5", "Build the shaders again; a shader that is saved is built at once."},
    {"F12", "Write a picture."},
    {"F1", "This card."},
    {"Esc", "Close the topmost; with nothing open, quit."},
});

constexpr std::array crowd_lines = std::to_array<HelpLine>({
    {"Agent", "One character of the crowd."},
    {"Role", "Something that agents do: walk, wave, sit. A clip plays it."},
    {"Clip", "An animation of a character, from its file."},
    {"Cast", "The characters of the crowd and their shares."},
    {"Seed", "Decides places, phases and looks. The same seed is the same crowd."},
    {"Snapshot", "The crowd as it was at a moment, to go back to."},
    {"Recording", "All that was asked for and the poses that came of it, to be repeated to the bit."},
    {"Preset", "All values and the camera, under a name."},
});

constexpr std::array detail_lines = std::to_array<HelpLine>({
    {"Interval", "Frames from one update of an agent to the next. 1 is full rate."},
    {"Skipping", "Agents with longer intervals are posed in turns, fewer in each frame."},
    {"Smoothing", "Between two updates an agent blends from one pose to the next."},
    {"Bone level", "How many bones of the ordered list are posed. The others follow their parents."},
    {"Mesh LOD", "How many triangles a character is drawn with."},
    {"Rule", "What decides the intervals: the error on screen, the distance, or nothing."},
    {"Error", "How far a pose is from the exact one on the screen, in pixels."},
    {"p50, p99", "The error that half of the samples stay below, and 99 of 100."},
    {"Pop", "How far the error of an agent jumps from one frame to the next, in pixels."},
    {"Error limit", "The p99 that level of detail may reach."},
    {"Tolerance", "The error for one agent that keeps the crowd within the limit. It is found from frame to frame."},
    {"Time limit", "Milliseconds of all PUs that posing may take in a frame, as predicted."},
});

constexpr std::array scheduling_lines = std::to_array<HelpLine>({
    {"PU", "Processing unit: a thread with a small memory of its own, as a core of a Cell processor."},
    {"Local store", "That memory. Entities are copied in, updated there and copied out."},
    {"L1, L2", "The processor's caches: a store of that size stays in one of them."},
    {"Tile", "The agents that a PU updates at a time."},
    {"Grain", "The work that a PU takes from the queue at once, in microseconds."},
    {"Schedule", "fused: a tile goes through all entities in one go. levels: one priority after the other."},
    {"Double buffer", "The next tile is copied in while this one is updated."},
    {"Priority", "The order of updates: whatever reads another entity comes after it."},
    {"Stream", "How clips are stored: as keys with the times between them, or as samples."},
    {"Palette", "The bones of an agent as the graphics card reads them: matrices, or less."},
    {"Sweep", "Goes through the range of one value and measures each stop."},
});

constexpr std::array entity_lines = std::to_array<HelpLine>({
    {"Entity", "A part of what makes a pose: a player, a blender, a layer, a look-at."},
    {"Player", "Plays a clip. A blender mixes several."},
    {"Block", "The bytes of an entity. They hold no pointers, so a PU can copy them."},
    {"Handle", "Names a block: pool, generation and index."},
    {"Channel", "Plays clips one after the other and fades between them. Several of an agent are mixed."},
    {"Layer", "Lies over a pose: an additive clip, or one on some bones."},
    {"Rag-doll", "Lets a character fall by physics."},
});

constexpr std::array chapters = std::to_array<HelpChapter>({{"Keys", key_lines},
                                                            {"Crowd", crowd_lines},
                                                            {"Level of detail", detail_lines},
                                                            {"Scheduling", scheduling_lines},
                                                            {"Entities", entity_lines}});

constexpr float help_width = 440, help_word_width = 104, help_margin = 16, help_line_gap = 5, chapter_height = 26,
                search_line_height = 36;

std::vector<HelpLine> found_in(const HelpChapter& chapter, const std::string& searched) {
  std::vector<HelpLine> lines;
  for (const HelpLine& line : chapter.lines) {
    if (has_letters(line.word, searched) || has_letters(line.meaning, searched)) lines.push_back(line);
  }
  return lines;
}

float meaning_width(const Theme& theme) { return theme.px(help_width - 2 * help_margin - help_word_width - 12); }

float height_of_line(const Theme& theme, const HelpLine& line) {
  return wrapped_height(theme.regular, meaning_width(theme), line.meaning) + theme.px(help_line_gap);
}

float draw_help_line(const Theme& theme, ImVec2 at, const HelpLine& line) {
  draw_text(theme.regular, at, colour::accent, line.word);
  draw_wrapped(theme.regular, {at.x + theme.px(help_word_width), at.y}, colour::text, meaning_width(theme),
               line.meaning);
  return at.y + height_of_line(theme, line);
}

}  // namespace

bool show_help_card(Widgets& widgets, const Area& crowd, std::string& searched) {
  const Theme& theme = widgets.theme();
  std::vector<std::pair<const char*, std::vector<HelpLine>>> found;
  float height = theme.px(search_line_height + help_margin);
  for (const HelpChapter& chapter : chapters) {
    std::vector<HelpLine> lines = found_in(chapter, searched);
    if (lines.empty()) continue;
    height += theme.px(chapter_height + help_line_gap);
    for (const HelpLine& line : lines) height += height_of_line(theme, line);
    found.emplace_back(chapter.title, std::move(lines));
  }
  const ImVec2 size(theme.px(help_width), height);
  const Card card(
      widgets, "Help", crowd,
      {.at = {crowd.from.x + (crowd.width() - size.x) / 2, crowd.from.y + crowd.height() * 0.3F}, .size = size});
  if (!card.is_unfolded()) return card.was_closed();
  ImVec2 at(card.content().from.x + theme.px(help_margin), card.content().from.y + theme.px(6));
  ImGui::SetCursorScreenPos(at);
  widgets.text("Search", searched, "a key or a word", {.what = "Shows the lines that have these letters."});
  at.y += theme.px(search_line_height);
  for (const auto& [title, lines] : found) {
    draw_text(theme.strong, at, colour::text, title);
    at.y += theme.px(chapter_height);
    for (const HelpLine& line : lines) at.y = draw_help_line(theme, at, line);
    at.y += theme.px(help_line_gap);
  }
  return card.was_closed();
}

}  // namespace throng::app
