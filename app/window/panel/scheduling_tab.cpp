#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>

#include "app/files/byte_hash.h"
#include "app/show/report/tuning_sweep.h"
#include "app/window/panel/tabs.h"
#include "engine/base/text/size_text.h"

namespace throng::app {
namespace {

template <std::size_t count>
constexpr std::array<int, count + 1> zero_and(const std::array<int, count>& stops) {
  std::array<int, count + 1> all{};
  std::ranges::copy(stops, all.begin() + 1);
  return all;
}
constexpr auto local_store_choices = zero_and(local_store_stops);
constexpr auto tile_choices = zero_and(tile_stops);
constexpr auto grain_choices = zero_and(grain_stops);

// The table has it in nanoseconds, people read microseconds.
void show_grain(const TabContext& context) {
  double microseconds = swept_value(SweptValue::grain, context.tuning);
  context.unless_idle("cost_least_task_ns", [&] {
    if (context.widgets.number(
            tuning_value("cost_least_task_ns").label, microseconds, swept_value(SweptValue::grain, context.standard),
            scale_of("cost_least_task_ns", grain_choices),
            {.what =
                 "The least work for which another PU is woken: fewer take part where each would have less to do. A PU "
                 "then takes a tile at a time.",
             .unit = "microseconds of one PU, predicted; any: all PUs are woken, whatever there is to do",
             .cost = "Small: waking takes longer than the work. Large: PUs stand by while others work."})) {
      set_swept_value(SweptValue::grain, microseconds, context.tuning);
    }
  });
}

void show_machine(const TabContext& context) {
  context.widgets.section("Processing units");
  NumberScale threads = scale_of("pus");
  threads.highest = std::max(threads.highest, static_cast<double>(context.report.hardware_threads));
  context.row("pus", threads,
              {.what = "Worker threads, each with a local store of its own. The poses are the same for any number.",
               .unit = "threads; all: as many as the machine has",
               .cost = "More than the machine has only take turns."});
  context.row("local_store_kib", scale_of("local_store_kib", local_store_choices),
              {.what = "A PU's own memory: entities are copied in, updated there and copied out. Its size decides how "
                       "many characters fit into a tile. Too small for this skeleton is refused, with a line that says "
                       "what is needed.",
               .unit = "KiB; auto: 64, or what one character needs",
               .cost = "Small: narrow tiles. Large: out of the processor's own cache."});
  context.row("tile", scale_of("tile", tile_choices),
              {.what = "Characters that are handed to a PU at a time.",
               .unit = "characters; auto: as many as fit",
               .cost = "Narrow tiles leave vector lanes idle."});
  show_grain(context);
  context.row("schedule",
              {.what = "levels: all players, then blenders by priority, a barrier in between; states go back to main "
                       "memory after each. fused: a character from clips to palette in one go.",
               .cost = "levels moves more bytes and waits at barriers."});
  context.row("double_buffer",
              {.what = "off: fetch, compute, write back. inline: the next tile is fetched before this one is computed. "
                       "interleaved: while it is computed, asked for in slices.",
               .cost = "A second fetch buffer in the local store."});
  context.row("stream",
              {.what = "sampled: even rows of quantised rotations, made for crowds. keyframe: the clip's own keys, "
                       "exact, with the paper's interpolation structures.",
               .cost = "keyframe moves about 7 KB a player and needs a larger local store."});
  context.row("palette",
              {.what = "What is written for a bone: float, a 3x4 matrix of 48 bytes, or packed, a rotation and a "
                       "place of 16, unpacked in the vertex shader. Skeletons that are not rigid stay float.",
               .cost = "packed: arithmetic for every vertex that is drawn."});
}

using Cells = std::array<std::string, 8>;
/// Columns of the table of PUs, with their right edges in shares of its width. A narrow table leaves some out.
struct PuColumn {
  const char* title;
  float end, narrow_end;  // 0: it is left out
};
constexpr std::array<PuColumn, 8> pu_columns = {{{"PU", 0.05F, 0.07F},
                                                 {"tiles", 0.15F, 0.22F},
                                                 {"agents", 0.27F, 0},
                                                 {"busy ms", 0.45F, 0.48F},
                                                 {"in", 0.58F, 0.64F},
                                                 {"out", 0.72F, 0.82F},
                                                 {"transfers", 0.87F, 0},
                                                 {"store", 1.0F, 1.0F}}};

float end_of(const Theme& theme, const Area& row, std::size_t column) {
  const bool narrow = is_narrow(theme, row.width());
  return row.from.x + (narrow ? pu_columns.at(column).narrow_end : pu_columns.at(column).end) * row.width();
}

std::string as_kib(std::uint64_t bytes) {
  const double kib = static_cast<double>(bytes) / 1024;
  return fixed(kib, kib < 100 ? 1 : 0);
}

void draw_cells(const Theme& theme, const Area& row, ImU32 ink, const Cells& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const float end = end_of(theme, row, i);
    if (end > row.from.x) draw_text(theme.small, {end, row.from.y}, ink, cells[i], 1);
  }
}

void draw_busy_bar(const Theme& theme, const Area& row, float busy_share) {
  const float before = std::max(end_of(theme, row, 1), end_of(theme, row, 2));
  const float from = before + 0.02F * row.width(), to = end_of(theme, row, 3);
  const float y = row.to.y - theme.px(3), half = theme.px(1);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled({from, y - half}, {to, y + half}, colour::well_hovered);
  draw.AddRectFilled({from, y - half}, {from + (to - from) * std::clamp(busy_share, 0.0F, 1.0F), y + half},
                     colour::accent);
}

/// Shows a frame that has passed and the way back to the last ones.
void show_looked_at(const TabContext& context, const FrameDetails& frame, float seconds_ago) {
  Widgets& widgets = context.widgets;
  const std::string title =
      "Frame " + with_thousands(static_cast<std::uint64_t>(frame.number())) + ", " + fixed(seconds_ago, 1) + " s ago";
  widgets.section(title.c_str());
  widgets.fact("Frame, animation", fixed(frame.frame_ms, 2) + ", " + fixed(frame.update_ms, 2) + " ms",
               {.what = "The time of the whole frame, and of crowd, level of detail and poses in it."});
  widgets.fact("Agents updated", with_thousands(frame.work.agents_updated), {.what = "Those posed in that frame."});
  widgets.fact("Tiles", with_thousands(frame.tiles()), {.what = "Handed to PUs in that frame."});
  widgets.fact("Copied in, out", size_text(frame.work.copies.bytes_in) + ", " + size_text(frame.work.copies.bytes_out),
               {.what = "Entity blocks, over all PUs.", .unit = "bytes"});
  widgets.fact("Palettes written", size_text(frame.work.palette_bytes), {.what = "In that frame.", .unit = "bytes"});
  if (wide_button(widgets, "Back to the last frames",
                  {.what = "The table and the timeline show what happens now again."}))
    context.requests.ask(LookAtLastFrames{});
}

void show_pu_table(const TabContext& context, std::span<const PuReport> pus, float update_ms) {
  const Theme& theme = context.widgets.theme();
  context.widgets.section("What each PU did and moved, KiB");
  const float pitch = pus.size() > 8 ? 17 : 20, height = pitch * (static_cast<float>(pus.size()) + 1);
  const Area table = context.widgets.area("PU table", height);
  const auto row_at = [&](std::size_t i) {
    const float y = table.from.y + theme.px(pitch) * static_cast<float>(i);
    return Area{.from = {table.from.x, y}, .to = {table.to.x, y + theme.px(pitch)}};
  };
  Cells titles;
  std::ranges::transform(pu_columns, titles.begin(), &PuColumn::title);
  draw_cells(theme, row_at(0), colour::faint, titles);
  for (std::size_t i = 0; i < pus.size(); ++i) {
    const anim::PuActivity& pu = pus[i].activity;
    draw_busy_bar(theme, row_at(i + 1), static_cast<float>(pu.busy_ms) / std::max(update_ms, 1e-3F));
    draw_cells(theme, row_at(i + 1), colour::text,
               Cells{std::to_string(i), with_thousands(pu.tasks), with_thousands(pu.agents), fixed(pu.busy_ms, 2),
                     as_kib(pu.copies.bytes_in), as_kib(pu.copies.bytes_out), with_thousands(pu.copies.transfers),
                     as_kib(pus[i].local_store_laid_out_bytes)});
  }
}

void show_legend(const Theme& theme) {
  ImVec2 at = ImGui::GetCursorScreenPos();
  const auto show = [&](const char* word, ImU32 ink) {
    const float y = at.y + theme.px(4), size = theme.px(8);
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, y}, {at.x + size, y + size}, ink, theme.px(2));
    at.x += size + theme.px(5);
    draw_text(theme.small, at, colour::dim, word);
    at.x += text_width(theme.small, word) + theme.px(14);
  };
  show("fetch", colour::fetch);
  show("compute", colour::compute);
  show("write back", colour::write_back);
  show("wait", colour::wait);
  ImGui::Dummy({0, font_height(theme.small)});
}

void show_totals(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  std::size_t laid_out = 0;
  for (const PuReport& pu : report.pu) laid_out = std::max(laid_out, pu.local_store_laid_out_bytes);
  widgets.section("In all");
  widgets.fact("Local store laid out",
               size_text(laid_out) + " of " + std::to_string(report.schedule.local_store_bytes / bytes_a_kib) + " KiB",
               {.what = "Of each PU's local store: its fetch buffers and the scratch of a tile. The rest stays free."});
  widgets.fact("Tile width", counted(static_cast<std::size_t>(report.schedule.plan.width), "character"),
               {.what = "What the local store has room for, or what was asked for."});
  widgets.fact("Copied in, out",
               size_text(report.work.copies.bytes_in) + ", " + size_text(report.work.copies.bytes_out),
               {.what = "Entity blocks, in this frame, over all PUs.", .unit = "bytes"});
  widgets.fact("Palettes written", size_text(report.work.palette_bytes),
               {.what = "Straight into memory that the renderer reads, once.", .unit = "bytes in this frame"});
  widgets.fact("SIMD target", report.simd_target, {.what = "The vector instructions chosen for this processor."});
  widgets.fact("Pose hash", hex_string(report.pose_hash),
               {.what = "Over every bit of every palette so far. PUs, schedule, local store, tile and double buffer do "
                        "not change it."});
}

void show_memory(const TabContext& context) {
  const auto has_blocks = [](const anim::KindMemory& kind) {
    return kind.own.blocks_alive + kind.shared.blocks_alive > 0;
  };
  if (std::ranges::none_of(context.report.memory, has_blocks)) return;
  context.widgets.section("Blocks in main memory");
  for (const anim::KindMemory& kind : context.report.memory) {
    if (!has_blocks(kind)) continue;
    context.widgets.fact(kind.kind,
                         with_thousands(kind.own.blocks_alive + kind.shared.blocks_alive) + ", " +
                             size_text(kind.own.bytes_alive + kind.shared.bytes_alive),
                         {.what = "Living blocks of this kind of entity, of all agents, and what they take. The slabs "
                                  "they lie in have room for more."});
  }
}

}  // namespace

void show_scheduling_tab(const TabContext& context) {
  const FrameReport& report = context.report;
  const std::optional<FrameDetails>& looked_at = report.kept.looked_at;
  if (context.widgets.is_searching()) {
    show_machine(context);
    show_sweep(context);
    return;
  }
  // A click at the frame graph leads here, so its frame comes first.
  if (looked_at) show_looked_at(context, *looked_at, report.kept.seconds_ago);
  if (!looked_at) show_machine(context);
  if (!looked_at) show_sweep(context);
  show_pu_table(context, looked_at ? looked_at->pu : report.pu, looked_at ? looked_at->update_ms : report.update_ms);
  if (looked_at || !report.timeline.empty()) {
    context.widgets.section(looked_at ? "That update, PU by PU" : "Last updates, PU by PU");
    show_timeline(context);
    show_legend(context.widgets.theme());
    context.widgets.caption("Wheel: zoom. Drag: along. Double click: all.");
  }
  if (looked_at) return;
  show_totals(context);
  show_memory(context);
}

}  // namespace throng::app
