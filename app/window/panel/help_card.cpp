#include <algorithm>
#include <array>
#include <cstddef>
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
    {"Wheel", "Flying speed; Shift is faster."},
    {"Click", "Select a character; P pushes it over."},
    {"F", "Frame the crowd beside the panel."},
    {"Home", "Back to the scene's camera; a film has the camera again."},
    {"G", "Follow the selected character; again: no longer. With Shift: from behind, turning with it."},
    {"1 to 9", "Go to a place of the camera; Ctrl with it keeps the place."},
    {"X", "While held: the exact crowd, nothing skipped."},
    {"B", "Bring the other of two tunings into use."},
    {"Ctrl+Z, +Y", "Take back the last change of a value; make it again."},
    {"Ctrl+O, +S", "Open a file; save the crowd. Shift+Ctrl+S: under another name."},
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
    {"F11", "Fill the screen; back to the window. Alt+Enter too."},
    {"F12", "Write a picture of the window. With Shift: without the panel, in full quality."},
    {"V", "Make a video while the window goes on."},
    {"F1", "This card."},
    {"Ctrl +, -, 0", "A larger panel, a smaller one, as it was. Its edge can be dragged."},
    {"Esc", "Close the topmost; with nothing open, quit. Ctrl+Q closes the window."},
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
    {"Grain", "The least work for which another PU is woken, in microseconds."},
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

constexpr float help_width = 876, help_word_width = 104, help_margin = 16, help_line_gap = 4, chapter_height = 24,
                search_line_height = 34, column_gap = 24, least_column = 280;
constexpr float most_for_help = 0.95F;  // of the crowd, which a person who reads does not look at

std::vector<HelpLine> found_in(const HelpChapter& chapter, const std::string& searched) {
  std::vector<HelpLine> lines;
  for (const HelpLine& line : chapter.lines) {
    if (has_letters(line.word, searched) || has_letters(line.meaning, searched)) lines.push_back(line);
  }
  return lines;
}

/// The lines of a chapter in two columns of about equal height, or in one where the card is narrow.
class HelpColumns {
 public:
  HelpColumns(Widgets& widgets, float card_width) : widgets_(widgets), theme_(widgets.theme()) {
    const float all = card_width - theme_.px(2 * help_margin), half = (all - theme_.px(column_gap)) / 2;
    has_two_ = half >= theme_.px(least_column);
    width_ = has_two_ ? half : all;
  }

  [[nodiscard]] float height_of(std::span<const HelpLine> lines) const {
    const std::size_t first = first_column(lines);
    return std::max(sum_of(lines.first(first)), sum_of(lines.subspan(first)));
  }
  void draw(ImVec2 at, std::span<const HelpLine> lines) const {
    const std::size_t first = first_column(lines);
    draw_column(at, lines.first(first));
    draw_column({at.x + width_ + theme_.px(column_gap), at.y}, lines.subspan(first));
  }

 private:
  [[nodiscard]] float meaning_width() const { return width_ - theme_.px(help_word_width); }
  [[nodiscard]] float height_of(const HelpLine& line) const {
    return wrapped_size(theme_.regular, meaning_width(), line.meaning).y + theme_.px(help_line_gap);
  }
  [[nodiscard]] float sum_of(std::span<const HelpLine> lines) const {
    float sum = 0;
    for (const HelpLine& line : lines) sum += height_of(line);
    return sum;
  }
  [[nodiscard]] std::size_t first_column(std::span<const HelpLine> lines) const {
    if (!has_two_) return lines.size();
    const float half = sum_of(lines) / 2;
    std::size_t count = 0;
    for (float sum = 0; count < lines.size() && sum < half; ++count) sum += height_of(lines[count]);
    return count;
  }
  void draw_column(ImVec2 at, std::span<const HelpLine> lines) const {
    for (const HelpLine& line : lines) {
      draw_text(theme_.regular, at, colour::accent, line.word);
      draw_wrapped(theme_.regular, {at.x + theme_.px(help_word_width), at.y}, colour::text, meaning_width(),
                   line.meaning);
      const float below = at.y + height_of(line);
      widgets_.record(std::string("help:") + line.word, {.from = at, .to = {at.x + width_, below}});
      at.y = below;
    }
  }

  Widgets& widgets_;
  const Theme& theme_;
  float width_;  ///< of a column
  bool has_two_;
};

}  // namespace

bool show_help_card(Widgets& widgets, const Area& crowd, std::string& searched) {
  const Theme& theme = widgets.theme();
  const float width = std::min(theme.px(help_width), crowd.width() - theme.px(24));
  const HelpColumns columns(widgets, width);
  std::vector<std::pair<const char*, std::vector<HelpLine>>> found;
  float height = theme.px(search_line_height + help_margin);
  for (const HelpChapter& chapter : chapters) {
    std::vector<HelpLine> lines = found_in(chapter, searched);
    if (lines.empty()) continue;
    height += theme.px(chapter_height + help_line_gap) + columns.height_of(lines);
    found.emplace_back(chapter.title, std::move(lines));
  }
  const Card card(widgets, "Help", crowd,
                  {.at = {crowd.from.x + (crowd.width() - width) / 2, crowd.from.y},
                   .size = {width, height},
                   .most = most_for_help});
  if (!card.is_unfolded()) return card.was_closed();
  ImVec2 at(card.content().from.x + theme.px(help_margin), card.content().from.y + theme.px(6));
  ImGui::SetCursorScreenPos(at);
  widgets.text("Search", searched, "a key or a word", {.what = "Shows the lines that have these letters."});
  at.y += theme.px(search_line_height);
  for (const auto& [title, lines] : found) {
    draw_text(theme.strong, at, colour::text, title);
    at.y += theme.px(chapter_height);
    columns.draw(at, lines);
    at.y += columns.height_of(lines) + theme.px(help_line_gap);
  }
  return card.was_closed();
}

}  // namespace throng::app
