#include "throng/crowd_view.h"

#include <algorithm>
#include <map>
#include <utility>

#include "throng/render/crowd_mesh_data.h"

#include "engine/anim/api/crowd_parts.h"
#include "engine/anim/api/taken_agents.h"
#include "engine/anim/base/misuse.h"
#include "engine/base/glm_numbers.h"
#include "engine/crowd/sorted_draws.h"
#include "engine/crowd/system_view.h"

namespace throng {
namespace {

constexpr const char* chooses = "CrowdView::choose";
constexpr std::uint64_t frames_without_completion = 64;  // more than any device lags behind
constexpr std::size_t most_mesh_lods = render::largest_mesh_lod_count;

/// Returns sizes for the palettes of characters that come later: each is a quarter larger than the last, up to that of
/// the most bones.
std::vector<std::size_t> sizes_of_palettes() {
  std::vector<std::size_t> sizes;
  for (std::size_t entries = 4; entries < anim::max_bones; entries += entries / 4) {
    sizes.push_back(anim::palette_stride(entries, PaletteFormat::matrices));
  }
  sizes.push_back(anim::palette_stride(anim::max_bones, PaletteFormat::matrices));
  return sizes;
}

/// Returns the characters of a crowd by number. Another one stands where no character has the number.
std::vector<ViewedCharacter> viewed_characters(const detail::CrowdParts& parts) {
  std::vector<ViewedCharacter> viewed;
  const auto any = std::ranges::find_if(parts.characters, [](const auto& one) { return bool(one.character); });
  for (const detail::CrowdCharacter& one : parts.characters) {
    viewed.push_back({.character = detail::baked_of(one.character ? one.character : any->character)});
  }
  return viewed;
}

/// Returns why a frame cannot be shown, in one sentence; null if it can.
const char* fault_of(const ViewFrame& frame, std::size_t numbers) {
  for (const char* fault : {detail::fault_of({frame.positions, frame.scales}, numbers), detail::fault_of(frame.camera),
                            detail::fault_of(frame.rules.lod), detail::fault_of_step(frame.frame_step)}) {
    if (fault != nullptr) return fault;
  }
  if (!frame.headings.empty() && frame.headings.size() < numbers) {
    return "the frame's headings have no place for each number";
  }
  const bool is_picture = frame.width > 0.0F && frame.height > 0.0F;
  return is_picture ? nullptr : "the width and height of a picture are above 0";
}

}  // namespace

struct CrowdView::State {
  struct ToldMeshes {
    CharacterId character;
    std::vector<render::MeshError> errors;  // metres; the full mesh first
    std::vector<std::uint32_t> triangles;
  };

  explicit State(render::PalettePageSource& its_pages) : pages(&its_pages) {}

  render::PalettePageSource* pages;
  std::optional<SystemView> view;                // none before the first frame
  std::uint64_t characters = UINT64_MAX;         // CrowdParts::version that the characters are of
  std::map<std::uint32_t, ToldMeshes> meshes{};  // by the character's number
  detail::TakenAgents agents{};
  std::vector<Heading> headings{};  // [number]
  SystemFrame frame{};
  SortedDraws sorted{};
  bool has_chosen = false;

  PlacedAgents placed() const {
    const anim::LodCrowd taken = agents.agents();
    return {
        .positions = taken.positions, .headings = headings, .scales = taken.scales, .characters = taken.character_of};
  }
  void set_meshes() {
    for (const auto& [number, told] : meshes) {
      if (number >= view->characters().size()) continue;
      const double height = view->characters()[number].character->bounds.height;
      std::vector<render::MeshError> shares;
      for (const render::MeshError& metres : told.errors) shares.push_back(shares_of(metres, height));
      view->mesh_lods().set(number, std::move(shares), told.triangles);
    }
  }
};

CrowdView::CrowdView(render::PalettePageSource& pages) : state_(std::make_unique<State>(pages)) {}
CrowdView::~CrowdView() = default;
CrowdView::CrowdView(CrowdView&&) noexcept = default;
CrowdView& CrowdView::operator=(CrowdView&&) noexcept = default;

bool CrowdView::is_gone(const char* call) const {
  return state_ == nullptr && !anim::report_misuse({call, detail::was_moved_from});
}

Status CrowdView::set_mesh_lods(CharacterId character, const render::MeshLodList& meshes) {
  const auto& [errors, triangles] = meshes;
  constexpr const char* call = "CrowdView::set_mesh_lods";
  if (state_ == nullptr) return anim::refuse({call, detail::was_moved_from});
  if (errors.size() != triangles.size() || errors.empty() || errors.size() > most_mesh_lods) {
    return anim::refuse({call, "a character has 1 to 7 meshes, each with an error and a number of triangles"});
  }
  state_->meshes[character.number] = {character, {errors.begin(), errors.end()}, {triangles.begin(), triangles.end()}};
  if (state_->view) state_->set_meshes();
  return Done{};
}

void CrowdView::take_characters(const Crowd& crowd) {
  State& s = *state_;
  const detail::CrowdParts& parts = crowd.parts();
  if (s.characters == parts.version) return;
  s.characters = parts.version;
  if (!s.view) {
    s.view.emplace(viewed_characters(parts), *s.pages, 0, sizes_of_palettes());
  } else {
    s.view->set_characters(viewed_characters(parts));
  }
  std::erase_if(s.meshes, [&](const auto& told) { return !parts.system->characters().has(told.second.character); });
  s.set_meshes();
  s.view->reset(s.agents.room(), s.frame.rules.lod);
}

std::span<PoseRequest> CrowdView::choose(Crowd& crowd, const ViewFrame& frame) {
  if (is_gone(chooses)) return {};
  State& s = *state_;
  s.has_chosen = false;
  if (const char* fault = fault_of(frame, crowd.number_limit()); fault != nullptr) {
    anim::report_misuse({chooses, fault});
    return {};
  }
  const detail::CrowdParts& parts = crowd.parts();
  if (parts.characters.empty()) return {};  // it was moved from, as number_limit() has reported
  take_characters(crowd);
  if (s.agents.make_room(crowd.number_limit())) {
    s.headings.resize(s.agents.room());
    s.view->reset(s.agents.room(), frame.rules.lod);
  }
  s.agents.take(crowd, {frame.positions, frame.scales}, chooses);
  s.agents.tell(crowd, s.view->level_of_detail());
  std::ranges::copy(frame.headings.first(std::min<std::size_t>(frame.headings.size(), s.headings.size())),
                    s.headings.begin());
  const anim::LodCrowd taken = s.agents.agents();
  s.frame = {.agents = s.placed(),
             .clips = taken.clips,
             .absent = taken.absent,
             .rules = frame.rules,
             .sampling = frame.projection == Mat4{} ? ErrorSampling::off : ErrorSampling::some,
             .camera = frame.camera,
             .view = to_glm(frame.view),
             .projection = to_glm(frame.projection),
             .size = {frame.width, frame.height},
             .step = frame.frame_step,
             .completed = frame.completed};
  if (frame.completed == 0 && s.view->frame() == frames_without_completion) {
    anim::report_misuse({chooses, "ViewFrame::completed has stayed 0, so no memory of palettes is written again"});
  }
  s.view->choose(*parts.system, s.frame);
  s.has_chosen = true;
  for (PoseRequest& request : s.view->updates()) request.agent = parts.system->id(request.agent.number);
  return s.view->updates();
}

void CrowdView::pose(Crowd& crowd) {
  constexpr const char* call = "CrowdView::pose";
  if (is_gone(call)) return;
  State& s = *state_;
  if (!std::exchange(s.has_chosen, false)) {
    anim::report_misuse({call, "there was no choice since the last call"});
    return;
  }
  anim::AnimationSystem& system = *crowd.parts().system;
  for (PoseRequest& request : s.view->updates()) {
    const std::uint32_t number = request.agent.number;
    const bool plays = !std::as_const(system).agent(number).graph().empty();  // else its palette stays unwritten
    if (plays && s.view->level_of_detail().is_visible(number)) s.view->show(system, s.frame, request);
  }
  s.view->pose(system, s.frame);
}

CrowdDraws CrowdView::draws(const Crowd& crowd, const WornOutfits& worn) {
  constexpr const char* call = "CrowdView::draws";
  if (is_gone(call)) return {};
  State& s = *state_;
  if (!s.view) {
    anim::report_misuse({call, "no frame was chosen yet"});
    return {};
  }
  if (!worn.outfits.empty() && worn.outfits.size() < crowd.number_limit()) {
    anim::report_misuse({call, "WornOutfits::outfits has no place for each number"});
    return {};
  }
  s.sorted.compose(*s.view, *crowd.parts().system,
                   {.agents = s.placed(),
                    .outfits = worn.outfits,
                    .outfits_number = worn.outfits.empty() ? 0 : worn.number,
                    .silhouettes_cast = worn.silhouettes_cast});
  return {.instances = s.sorted.instances(),
          .batches = s.sorted.batches(),
          .drawn = s.sorted.drawn(),
          .runs = s.sorted.runs(),
          .morph_weights = s.sorted.morph_weights(),
          .now = s.view->now()};
}

void CrowdView::make_due(AgentId agent) {
  if (is_gone("CrowdView::make_due") || !state_->view) return;
  if (agent.number < state_->agents.room()) state_->view->level_of_detail().make_due(agent.number);
}

bool CrowdView::is_visible(AgentId agent) const {
  if (is_gone("CrowdView::is_visible") || !state_->view) return false;
  return agent.number < state_->agents.room() && state_->view->level_of_detail().is_visible(agent.number);
}

std::uint64_t CrowdView::frame() const {
  if (is_gone("CrowdView::frame") || !state_->view) return 0;
  return state_->view->frame();
}

ViewFigures CrowdView::figures() const {
  if (is_gone("CrowdView::figures") || !state_->view) return {};
  const SystemView& view = *state_->view;
  const anim::ErrorFigures& error = view.error_meter().figures();
  return {.agents_in_view = static_cast<std::uint32_t>(view.selection().visible.size()),
          .agents_posed = static_cast<std::uint32_t>(view.updates().size()),
          .triangles = view.mesh_choice().figures().triangles,
          .error_p50 = error.p50,
          .error_p99 = error.p99,
          .error_max = std::max(error.max, error.p99),  // percentiles look further back where samples are few
          .error_samples = error.samples,
          .out_of_memory = view.shown().out_of_memory()};
}

}  // namespace throng
