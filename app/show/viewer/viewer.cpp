#include "app/show/viewer/viewer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include <glm/vec3.hpp>

#include "app/settings/agent_colors.h"
#include "app/show/stage/stage.h"

namespace throng::app {
namespace {

constexpr float view_radius = 1.0F;     // metres, of the sphere that a character is drawn to fill
constexpr double shortest_clip = 1e-6;  // seconds
constexpr int ring_corners = 64;
constexpr std::uint32_t entry_of_none = 65536;

bool has_clip(const anim::Character& character, int clip) {
  return clip >= 0 && static_cast<std::size_t>(clip) < character.clips.size() &&
         !character.clips[static_cast<std::size_t>(clip)].is_empty();
}

std::optional<std::uint32_t> first_agent_of(const Crowd& crowd, std::size_t character) {
  const auto found = std::ranges::find(crowd.characters(), character);
  if (found == crowd.characters().end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - crowd.characters().begin());
}

// The clip that is asked for, else the agent's, else the one to stand with, else the first.
int first_clip(const Stage& stage, const ViewRequest& request) {
  const CharacterSource& source = stage.characters()[request.character];
  const int of_agent = request.agent ? stage.crowd().minds().clips()[*request.agent] : no_clip;
  const int of_preview = request.preview ? request.preview->clip : no_clip;
  for (const int clip : {request.clip.value_or(no_clip), of_preview, of_agent, source.roles.clip(Role::stand)}) {
    if (has_clip(*source.character, clip)) return clip;
  }
  const auto any = std::ranges::find_if(source.character->clips, [](const auto& clip) { return !clip.is_empty(); });
  return static_cast<int>(any - source.character->clips.begin());
}

Status check(const Stage& stage, const ViewRequest& request) {
  if (request.character >= stage.people().size()) return Error{"there is no such character to view"};
  if (request.agent && *request.agent >= stage.crowd().size()) return Error{"there is no such agent to view"};
  if (request.clip && !has_clip(*stage.characters()[request.character].character, *request.clip)) {
    return Error{"the character has no such clip to view"};
  }
  return Done{};
}

/// Returns the palette entries that a bone moves; an entry without vertices for a bone that no skin uses.
render::WeighedEntries entries_of(const anim::Skeleton& skeleton, int bone) {
  const auto first = std::ranges::lower_bound(skeleton.palette, bone, {}, &anim::PaletteEntry::bone);
  const auto end = std::ranges::upper_bound(skeleton.palette, bone, {}, &anim::PaletteEntry::bone);
  if (first == end) return {entry_of_none, 1};
  return {static_cast<std::uint32_t>(first - skeleton.palette.begin()), static_cast<std::uint32_t>(end - first)};
}

/// Adds a circle about `centre` between two directions of length 1.
void add_ring(std::vector<render::SceneLine>& lines, const glm::vec3& centre, float radius, const glm::vec3& right,
              const glm::vec3& up) {
  const auto corner = [&](int i) {
    const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / ring_corners;
    return centre + radius * (std::cos(angle) * right + std::sin(angle) * up);
  };
  for (int i = 0; i < ring_corners; ++i) lines.push_back({corner(i), corner(i + 1), bounds_color});
}

}  // namespace

Result<std::unique_ptr<Viewer>> Viewer::create(const Stage& stage, const ViewRequest& request,
                                               std::vector<ViewedMesh> meshes) {
  if (const Status checked = check(stage, request); !checked) return checked.error();
  auto viewed = ViewedCharacter::create(stage.characters()[request.character], stage.tuning().system.stream);
  if (!viewed) return viewed.error();
  std::unique_ptr<Viewer> viewer(new Viewer(stage, request, std::move(*viewed)));
  viewer->meshes_ = std::move(meshes);
  return viewer;
}

Viewer::Viewer(const Stage& stage, const ViewRequest& request, std::unique_ptr<ViewedCharacter> viewed)
    : character_(request.character),
      viewed_(std::move(viewed)),
      slots_(&stage.posed().shown().slots()),
      slot_(slots_->acquire(viewed_->palette_bytes())),
      stage_frame_(stage.posed().frame()),
      room_(viewed_->surroundings()),
      scale_(view_radius / room_.radius),
      turntable_(scale_ * room_.centre, scale_ * room_.across, scale_ * room_.half_height),
      preview_(request.preview) {
  settings_.clip = first_clip(stage, request);
  dress(stage, request.agent ? request.agent : first_agent_of(stage.crowd(), character_));
  pose();
}

Viewer::~Viewer() {
  if (slot_.valid()) slots_->retire(slot_, stage_frame_);
}

// In the colours of an agent, but in the shape that its file has.
void Viewer::dress(const Stage& stage, std::optional<std::uint32_t> agent) {
  record_ = {};
  record_.scale = scale_;
  record_.heading_cosine = 1.0F;
  record_.contact_scale = static_cast<float>(viewed_->source().roles.size());
  if (!agent) return;
  const Crowd& crowd = stage.crowd();
  look_ = crowd.looks().drawn[*agent];
  look_.shape = look_.hair = 0;
}

void Viewer::choose(const ViewerSettings& settings) {
  const ViewerSettings before = settings_;
  const double share = seconds_ / length();
  settings_ = settings;
  const anim::Character& character = viewed_->character();
  if (!has_clip(character, settings_.clip)) settings_.clip = before.clip;
  if (!has_clip(character, settings_.blended)) settings_.blended = no_clip;
  settings_.bone_level = std::clamp(settings_.bone_level, 0, static_cast<int>(character.level_entries.size()) - 1);
  settings_.mesh_lod = std::clamp(settings_.mesh_lod, 0, std::max(static_cast<int>(meshes_.size()) - 1, 0));
  if (settings_.weighed_bone >= character.skeleton.bone_count()) settings_.weighed_bone = -1;
  settings_.weight = std::clamp(settings_.weight, 0.0F, 1.0F);
  seconds_ = share * length();
  if (settings_.clip != before.clip) {
    seconds_ = 0.0;
    if (preview_) preview_->clip = settings_.clip;
  } else if (settings_.plays && !before.plays && !settings_.loops && has_ended()) {
    seconds_ = settings_.speed < 0.0F ? length() : 0.0;  // once more
  }
}

void Viewer::scrub(float seconds) {
  settings_.plays = false;
  settings_.bind_pose = false;
  seconds_ = std::clamp(static_cast<double>(seconds), 0.0, length());
}

double Viewer::seconds_of(int clip) const {
  const Ticks duration = viewed_->character().clips[static_cast<std::size_t>(clip)].duration;
  return std::max(to_seconds(duration), shortest_clip);
}

// Blended clips go in step, so both take a time between their lengths.
double Viewer::length() const {
  const double own = seconds_of(settings_.clip);
  if (settings_.blended == no_clip) return own;
  return own + (seconds_of(settings_.blended) - own) * static_cast<double>(settings_.weight);
}

bool Viewer::has_ended() const {
  return (settings_.speed > 0.0F && seconds_ >= length()) || (settings_.speed < 0.0F && seconds_ <= 0.0);
}

void Viewer::advance(Ticks delta) {
  const double passed = to_seconds(delta);
  if (settings_.turns) turntable_.turn(static_cast<float>(passed));
  if (settings_.plays && !settings_.bind_pose) {
    const double all = length(), next = seconds_ + passed * static_cast<double>(settings_.speed);
    seconds_ = settings_.loops ? next - std::floor(next / all) * all : std::clamp(next, 0.0, all);
    if (!settings_.loops && has_ended()) settings_.plays = false;
  }
  pose();
}

void Viewer::pose() {
  const double share = seconds_ / length();
  ViewedPose wanted{.clip = settings_.clip,
                    .seconds = share * seconds_of(settings_.clip),
                    .bind_pose = settings_.bind_pose,
                    .bone_level = static_cast<std::uint8_t>(settings_.bone_level)};
  if (settings_.blended != no_clip) {
    wanted.blended = settings_.blended;
    wanted.blended_seconds = share * seconds_of(settings_.blended);
    wanted.weight = settings_.weight;
  }
  viewed_->pose(wanted);
}

render::CrowdFrame Viewer::frame(const render::CameraView& camera) {
  render::CrowdFrame frame{.camera = camera, .instances = {}, .batches = {}, .bones_as_lines = settings_.bones};
  drawn_from_ = camera;
  lines_.clear();
  if (settings_.bounds) add_bounds();
  frame.lines = lines_;
  if (!slot_.valid()) return frame;  // no memory of the device is left
  const auto palette = std::as_bytes(viewed_->palette());
  std::memcpy(slots_->memory(slot_), palette.data(), palette.size());
  record_.palette_from = record_.palette_to = slot_.first_line;
  record_.bone_level = static_cast<std::uint32_t>(settings_.bone_level);
  morph_weights_.assign(viewed_->character().morph_bones.size(), 0);
  record_.weights = viewed_->add_morph_weights(morph_weights_) ? 1 : 0;
  batch_ = {.page = slot_.page,
            .character = static_cast<std::uint8_t>(character_),
            .mesh_lod = static_cast<std::uint8_t>(settings_.mesh_lod),
            .first = 0,
            .count = 1};
  frame.instances = {&record_, 1};
  frame.batches = {&batch_, 1};
  frame.looks = {&look_, 1};
  frame.looks_number = looks_number_;
  frame.morph_weights = morph_weights_;
  if (settings_.weighed_bone >= 0) frame.weighed = entries_of(viewed_->character().skeleton, settings_.weighed_bone);
  return frame;
}

// Adds the sphere that no pose leaves, and the cylinder of the body.
void Viewer::add_bounds() {
  const anim::CharacterBounds& bounds = viewed_->character().bounds;
  const glm::vec3 centre(0.0F, scale_ * static_cast<float>(bounds.height / 2), 0.0F);
  const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  for (const auto& [right, up] : {std::pair(x, y), std::pair(y, z), std::pair(z, x)}) {
    add_ring(lines_, centre, scale_ * static_cast<float>(bounds.reach), right, up);
  }
  const float radius = scale_ * static_cast<float>(bounds.body_radius), top = 2.0F * centre.y;
  for (const float height : {0.0F, top}) add_ring(lines_, {0.0F, height, 0.0F}, radius, z, x);
  for (const glm::vec3& side : {x, -x, z, -z}) {
    lines_.push_back({radius * side, radius * side + top * y, bounds_color});
  }
}

std::vector<ViewedJoint> Viewer::joints() const {
  const glm::mat4 view_projection = drawn_from_.projection * drawn_from_.view;
  std::vector<ViewedJoint> joints;
  for (int bone = 0; bone < viewed_->character().skeleton.bone_count(); ++bone) {
    const auto joint = viewed_->joint(bone);
    if (!joint) continue;
    const glm::vec4 clip = view_projection * glm::vec4(scale_ * *joint, 1.0F);
    if (clip.w <= 0.0F) continue;
    joints.push_back({static_cast<std::size_t>(bone), 0.5F + 0.5F * clip.x / clip.w, 0.5F - 0.5F * clip.y / clip.w});
  }
  return joints;
}

ViewerReport Viewer::report() const {
  const anim::Character& character = viewed_->character();
  ViewerReport report{.character = character_,
                      .settings = settings_,
                      .clips = {},
                      .bones = {},
                      .joints = settings_.bones ? joints() : std::vector<ViewedJoint>(),
                      .seconds = static_cast<float>(seconds_),
                      .length = static_cast<float>(length()),
                      .height = static_cast<float>(character.bounds.height),
                      .reach = static_cast<float>(character.bounds.reach),
                      .drawn_scale = scale_,
                      .level_bones = character.skeleton.level_bone_counts,
                      .meshes = meshes_,
                      .preview = preview_};
  for (const anim::BakedClip& clip : character.clips) {
    report.clips.push_back({clip.name, static_cast<float>(to_seconds(clip.duration)), clip.loops});
  }
  for (const anim::Bone& bone : character.skeleton.bones) report.bones.push_back(bone.name);
  return report;
}

}  // namespace throng::app
