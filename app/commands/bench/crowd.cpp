#include "app/commands/bench/crowd.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <random>

#include "engine/anim/run/store/store_choice.h"

namespace throng::app {
namespace {

constexpr Ticks frame_step = ticks_per_second / 60;

anim::PlayRequest request(int clip, Ticks start) { return {.clip = clip, .start = start}; }

std::size_t packet_floats(const anim::Character& character) {
  return anim::packet_bytes(character.skeleton.components()) / sizeof(float);
}

}  // namespace

std::vector<BenchAgent> bench_agents(const anim::Character& character, int agents) {
  std::mt19937 generator(1);
  const auto random = [&generator] { return static_cast<std::uint32_t>(generator()); };
  const auto clip_count = static_cast<std::uint32_t>(character.clips.size());
  const auto start_in = [&](std::uint32_t clip) {
    const Ticks duration = std::max(character.clips[clip].duration, Ticks{1});
    return Ticks{static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(duration.count()))};
  };
  std::vector<BenchAgent> result;
  for (int i = 0; i < agents; ++i) {
    const std::uint32_t from = random() % clip_count;
    const std::uint32_t to = (from + 1 + random() % std::max(clip_count - 1, 1U)) % clip_count;
    result.push_back({.from_clip = static_cast<int>(from),
                      .to_clip = static_cast<int>(to),
                      .from_start = start_in(from),
                      .to_start = start_in(to),
                      .fraction = static_cast<float>(random() % 1000) / 1000.0F});
  }
  return result;
}

BenchPalettes::BenchPalettes(int agents, int entries, PaletteFormat format)
    : format_(format),
      slot_bytes_(anim::palette_stride(static_cast<std::size_t>(entries), format)),
      size_(slot_bytes_ * static_cast<std::size_t>(agents)),
      memory_(anim::allocate_aligned(size_)) {}

Result<SystemSubject> SystemSubject::create(std::shared_ptr<const anim::Character> character,
                                            const anim::SystemOptions& options, std::span<const BenchAgent> agents,
                                            const BenchPalettes& palettes) {
  auto system = anim::AnimationSystem::create(std::move(character), options);
  if (!system) return system.error();
  SystemSubject subject;
  subject.system_ = std::move(*system);
  subject.system_->set_agent_count(static_cast<std::uint32_t>(agents.size()));
  for (std::uint32_t i = 0; i < agents.size(); ++i) {
    subject.system_->agent(i).play(request(agents[i].from_clip, agents[i].from_start));
    subject.updates_.push_back({.agent = {i}, .palette = palettes.of(i)});
    if (agents[i].to_clip == BenchAgent::none) continue;
    anim::PlayRequest blended = request(agents[i].to_clip, agents[i].to_start);
    blended.held_fraction = agents[i].fraction;
    subject.system_->agent(i).play(blended);
  }
  return subject;
}

void SystemSubject::run() {
  system_->advance(step_);
  system_->update(updates_);
}

void SystemSubject::configure(const anim::SystemOptions& options) {
  const Status configured = system_->configure(options);
  assert(configured);
  static_cast<void>(configured);
}

KernelSubject::KernelSubject(const anim::Character& character, const anim::Kernels& kernels,
                             std::span<const BenchAgent> agents, const BenchPalettes& palettes)
    : character_(&character),
      kernels_(&kernels),
      agents_(agents),
      palettes_(&palettes),
      clocks_(character.clips.size()),
      stores_(anim::store_policy_for(palettes.floats().size_bytes(), anim::measured_cached_bytes())) {
  const std::size_t lanes = anim::widest_strip;
  const auto slots = static_cast<std::size_t>(character.hierarchy.slot_count) + 1;
  const std::size_t floats = packet_floats(character) * lanes + slots * anim::branch_slot_floats * lanes;
  scratch_ = anim::allocate_aligned(floats * sizeof(float));
  local_ = reinterpret_cast<float*>(scratch_.get());
  carry_ = local_ + packet_floats(character) * lanes;
  branches_ = carry_ + anim::branch_slot_floats * lanes;
}

void KernelSubject::run() {
  for (std::size_t clip = 0; clip < clocks_.size(); ++clip) {
    clocks_[clip] = (clocks_[clip] + frame_step) % std::max(character_->clips[clip].duration, Ticks{1});
  }
  for (std::size_t first = 0; first < agents_.size(); first += anim::widest_strip) {
    run_strip(agents_.subspan(first, std::min<std::size_t>(anim::widest_strip, agents_.size() - first)), first);
  }
  kernels_->fence_stores();
}

anim::ClipMoment KernelSubject::moment(int clip_index, Ticks start) const {
  const auto index = static_cast<std::size_t>(clip_index);
  const anim::BakedClip& clip = character_->clips[index];
  Ticks time = start + clocks_[index];
  if (time >= clip.duration) time -= clip.duration;
  return {.stream = clip.sampled(), .point = locate(*clip.sampled(), time)};
}

void KernelSubject::find_moments(std::span<const BenchAgent> agents) {
  clips_.begin(std::span(shown_).first(agents.size()));
  for (std::size_t i = 0; i < agents.size(); ++i) {
    const BenchAgent& agent = agents[i];
    const bool blended = agent.fraction > 0.0F && agent.to_clip >= 0;
    from_[i] = moment(agent.from_clip, agent.from_start);
    if (blended) to_[i] = moment(agent.to_clip, agent.to_start);
    shown_[i] = {.clip = &from_[i], .blended = blended ? &to_[i] : nullptr, .fraction = agent.fraction};
  }
  clips_.add(0, agents.size());
}

void KernelSubject::run_strip(std::span<const BenchAgent> agents, std::size_t first) {
  find_moments(agents);
  std::array<anim::PaletteDestination, anim::widest_strip> palettes{};
  for (std::size_t i = 0; i < agents.size(); ++i) palettes[i] = palettes_->of(first + i);
  const int bones = character_->skeleton.bone_count();
  const int components = character_->skeleton.components();
  anim::PoseClipsJob clips = clips_.job(components, local_);
  for (int packet = 0; packet < anim::packets_for(bones); ++packet) {
    clips.packet = packet;
    clips.displaced = anim::quads_of_packet(clips_.displaced_quads(), packet);
    kernels_->pose_clips(clips);
    kernels_->model_palette({.hierarchy = &character_->hierarchy,
                             .packet = packet,
                             .bone_count = bones,
                             .width = anim::widest_strip,
                             .characters = static_cast<int>(agents.size()),
                             .local = local_,
                             .displaced = clips.displaced,
                             .stores = stores_,
                             .carry = carry_,
                             .branch_slots = branches_,
                             .format = palettes_->format(),
                             .palettes = palettes.data(),
                             .hashes = nullptr});
  }
}

}  // namespace throng::app
