#include <algorithm>
#include <cmath>
#include <string>

#include "app/window/panel/cards.h"

namespace throng::app {
namespace {

namespace job_card {
constexpr float edge = 12, gap = 6, width = 380, height = 52, padding = 14, bar = 4, button = 62, button_height = 24;
}  // namespace job_card

std::string job_name(SideJob job) { return job == SideJob::loading ? "loading" : "video"; }

/// Draws how much is done; all of the bar is dim where that is not known.
void draw_share(const Theme& theme, ImVec2 from, float width, double share) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float round = theme.px(job_card::bar) / 2;
  const auto bar_to = [&](float part) { return ImVec2(from.x + part * width, from.y + theme.px(job_card::bar)); };
  draw.AddRectFilled(from, bar_to(1), share < 0 ? colour::accent_soft : colour::well_hovered, round);
  if (share > 0) draw.AddRectFilled(from, bar_to(std::min(static_cast<float>(share), 1.0F)), colour::accent, round);
}

void show_job(Widgets& widgets, const Area& place, const JobReport& job, Requests& requests) {
  const Theme& theme = widgets.theme();
  const std::string name = job_name(job.job);
  begin_fixed_window(("Job " + name).c_str(), place, theme.px(13));
  widgets.record("job:" + name, place);
  const ImVec2 from(place.from.x + theme.px(job_card::padding), place.from.y + theme.px(8));
  const float words_width = place.width() - theme.px(3 * job_card::padding + job_card::button);
  draw_text(theme.regular, from, colour::text, fitted(theme.regular, words_width, job.words));
  draw_share(theme, {from.x, from.y + font_height(theme.regular) + theme.px(10)}, words_width, job.share);
  ImGui::SetCursorScreenPos({place.to.x - theme.px(job_card::padding + job_card::button),
                             place.from.y + (place.height() - theme.px(job_card::button_height)) / 2});
  const char* const what = job.job == SideJob::video ? "Ends it. The frames so far are a whole video."
                                                     : "Ends it. What was there before stays.";
  if (widgets.named_button("Cancel", "cancel:" + name, {what}, theme.px(job_card::button))) {
    requests.ask(CancelJob{job.job});
  }
  ImGui::End();
  widgets.cover(place);
}

}  // namespace

float show_jobs(Widgets& widgets, const Area& crowd, const std::vector<JobReport>& jobs, Requests& requests) {
  const Theme& theme = widgets.theme();
  const ImVec2 size(std::min(theme.px(job_card::width), crowd.width() - theme.px(2 * job_card::edge)),
                    theme.px(job_card::height));
  ImVec2 at(crowd.from.x + theme.px(job_card::edge), crowd.from.y + theme.px(job_card::edge));
  for (const JobReport& job : jobs) {
    show_job(widgets, {.from = at, .to = {at.x + size.x, at.y + size.y}}, job, requests);
    at.y += size.y + theme.px(job_card::gap);
  }
  return jobs.empty() ? crowd.from.y : at.y - theme.px(job_card::edge);
}

void show_start_card(Widgets& widgets, const Area& window, const JobReport& job, Requests& requests) {
  const Theme& theme = widgets.theme();
  const ImVec2 size(std::min(theme.px(job_card::width), window.width()), theme.px(job_card::height));
  const ImVec2 at(std::floor((window.width() - size.x) / 2), std::floor((window.height() - size.y) / 2));
  show_job(widgets, {.from = at, .to = {at.x + size.x, at.y + size.y}}, job, requests);  // what comes later lies below
  begin_fixed_window("Start", window, 0, ImGuiWindowFlags_NoBackground);
  ImGui::GetWindowDrawList()->AddRectFilled(window.from, window.to, colour::panel | IM_COL32_A_MASK);
  draw_text(theme.large, {window.width() / 2, at.y - theme.px(40)}, colour::text, "Throng", 0.5F);
  ImGui::End();
}

}  // namespace throng::app
