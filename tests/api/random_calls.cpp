#include "tests/api/random_calls.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace throng::api_test {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr float no_float = std::numeric_limits<float>::quiet_NaN();
constexpr std::int64_t longest = std::numeric_limits<std::int64_t>::max();

void sway(const StepJob& job) {
  job.memory[0] = static_cast<std::byte>(static_cast<int>(job.memory[0]) + 1);
  job.pose.set_rotation(0, job.pose.rotation(1));
  if (job.memory[0] == std::byte{7}) job.pose.set_position(1, {no_float, 0.0F, infinite});
}

/// Returns a machine of the character's first clips, in which all kinds of transitions come often.
StateMachine restless_machine(const Character& character) {
  const auto clip = [&](std::uint32_t number) { return "\"" + std::string(character.clip({number}).name) + "\""; };
  const std::string text =
      R"({"inputs": [{"name": "x"}, {"name": "on", "value": true}, {"name": "go", "trigger": true}],
    "states": [{"name": "a", "by": "x", "points": [{"clip": )" +
      clip(0) + R"(, "at": 0}, {"clip": )" + clip(1) + R"(, "at": 1.5}]},
               {"name": "b", "clip": )" +
      clip(2) + R"(, "loop": false, "speed": -3}, {"name": "c", "clip": )" + clip(3) + R"(}],
    "transitions": [{"from": "*", "to": "a", "when": ["x > 0.5"], "fade": 0.1},
                    {"from": "a", "to": "b", "when": ["go"], "fade": 0.2},
                    {"from": "b", "to": "c", "at_end": true, "fade": 0.3},
                    {"from": "c", "to": "a", "when": ["not on"], "after": 0.01},
                    {"from": "*", "to": "b", "when": ["x < -0.2", "on"]},
                    {"from": "c", "to": "c", "at_end": true, "when": ["x <= 0"], "fade": 0.4}]})";
  const auto machine = StateMachine::parse(text, character);
  return machine ? *machine : StateMachine();
}

}  // namespace

RandomCalls::RandomCalls(const Character& character, std::uint32_t seed)
    : random_(seed), character_(character), machine_(restless_machine(character)) {
  begin_again();
}

float RandomCalls::number() {
  static constexpr std::array<float, 12> odd{0.0F,    1.0F,     -1.0F,  no_float, infinite, -infinite,
                                             3.4e38F, -3.4e38F, 1e-42F, 32767.0F, 32768.0F, 1e9F};
  if (one_in(4)) return odd[below(odd.size())];
  return static_cast<float>(below(4000)) / 1000.0F - 1.0F;
}

std::uint32_t RandomCalls::count() {
  static constexpr std::array<std::uint32_t, 8> odd{0, 1, 2, 31, 256, 1U << 20U, 0x7fffffff, 0xffffffff};
  return one_in(2) ? odd[below(odd.size())] : below(100);
}

int RandomCalls::index() { return one_in(3) ? static_cast<int>(count()) : static_cast<int>(below(70)) - 2; }

Ticks RandomCalls::time() {
  static constexpr std::array<std::int64_t, 9> odd{0,           1,     -1,     longest, -longest, -longest - 1,
                                                   longest / 2, 65536, 1 << 30};
  if (one_in(6)) return Ticks{odd[below(odd.size())]};
  return ticks_per_second * below(1000) / 500;
}

Place RandomCalls::place() { return {.position = vector(), .rotation = {number(), number(), number(), number()}}; }

AgentId RandomCalls::agent_id() {
  if (!known_agents_.empty() && !one_in(5))
    return known_agents_[below(static_cast<std::uint32_t>(known_agents_.size()))];
  return {.number = one_in(2) ? below(most_agents) : count(), .generation = one_in(2) ? whichever : count()};
}

CharacterId RandomCalls::character_id() {
  if (!one_in(5)) return known_characters_[below(static_cast<std::uint32_t>(known_characters_.size()))];
  return {count(), one_in(2) ? whichever : count()};
}

Play RandomCalls::play() {
  Play request{
      .clip = clip(), .fade = time(), .speed = static_cast<double>(number()), .start = time(), .loop = one_in(2)};
  if (one_in(3)) request.mask = mask();
  if (one_in(8)) request.absolute_root = place();
  return request;
}

CrowdOptions RandomCalls::options() {
  CrowdOptions options{.pus = static_cast<int>(1 + below(3)), .hash = one_in(2), .trace = one_in(2)};
  if (one_in(4)) options.pus = index();
  if (one_in(4)) options.local_store_bytes = count();
  if (one_in(4)) options.palettes = static_cast<PaletteFormat>(below(2));
  options.pus = options.pus > 8 && options.pus <= 256 ? 8 : options.pus;  // a thread each, in every such call
  return options;
}

void RandomCalls::begin_again() {
  crowd_ = std::make_unique<Crowd>(std::move(*Crowd::create(character_, {.pus = static_cast<int>(1 + below(2))})));
  lod_ = Lod();
  snapshot_ = Snapshot();
  known_characters_ = {CharacterId(0)};
  made_characters_ = {character_};
  steps_.clear();
  known_agents_.clear();
  for (const AgentId id : crowd_->add_agents(4)) known_agents_.push_back(id);
}

void RandomCalls::call() {
  ++calls_;
  if (known_agents_.size() > 200) known_agents_.erase(known_agents_.begin(), known_agents_.begin() + 100);
  switch (below(10)) {
    case 9:
      return call_many();
    case 8:
      return call_clips();
    case 0:
      return call_crowd();
    case 1:
      return call_characters();
    case 2:
    case 3:
      return call_agent();
    case 4:
      return add_process();
    case 5:
      return call_process();
    case 6:
      return call_motion();
    default:
      return call_lod();
  }
}

void RandomCalls::call_crowd() {
  switch (below(10)) {
    case 0:
      if (crowd_->agents().size() < most_agents) known_agents_.push_back(crowd_->add_agent(character_id()));
      return;
    case 1: {
      const std::uint32_t more = one_in(3) ? (one_in(2) ? 0xffffffff : (1U << 20U) + 1) : below(4);
      if (more < most_agents && crowd_->agents().size() + more > most_agents) return;
      for (const AgentId id : crowd_->add_agents(more, character_id())) known_agents_.push_back(id);
      return;
    }
    case 2:
    case 3:
      crowd_->remove_agent(agent_id());
      return;
    case 4:
      return crowd_->advance(time());
    case 5:
      return crowd_->snapshot(snapshot_);
    case 6:
      static_cast<void>(crowd_->restore(snapshot_));
      return;
    case 7:
      static_cast<void>(crowd_->configure(options()));
      return;
    case 8:
      if (one_in(20)) begin_again();
      return;
    default: {
      PoseRequest odd{.agent = agent_id(), .level = static_cast<std::uint8_t>(count()), .look_ahead = time()};
      odd.fade_level = static_cast<std::uint8_t>(count());
      odd.fade_halves = static_cast<std::uint8_t>(count());
      const std::array<PoseRequest, 2> twice{odd, odd};
      crowd_->update(twice);
      crowd_->pose_exactly(twice);
    }
  }
}

void RandomCalls::call_characters() {
  switch (below(7)) {
    case 6: {
      const std::array<int, 3> bones{index(), index(), index()};
      JointOutput output{.bones = std::span(bones).first(below(4)), .format = static_cast<JointFormat>(below(3))};
      if (one_in(3)) output.skin = index();
      static_cast<void>(crowd_->write_joints(character_id(), output));
      std::vector<LocalTransform> locals(one_in(2) ? 100 : below(70));
      crowd_->local_pose(agent_id(), locals);
      static_cast<void>(crowd_->bounds(agent_id()));
      return;
    }
    case 0:
      if (const auto added = crowd_->add(one_in(6) ? Character() : character_); added)
        known_characters_.push_back(*added);
      return;
    case 1:
    case 2:
      static_cast<void>(crowd_->remove(character_id()));
      return;
    case 3: {
      const std::array<BoneWeight, 2> bones{BoneWeight{index(), number()}, BoneWeight{index(), number()}};
      crowd_->add_mask(character_id(), bones, number());
      return;
    }
    case 4: {
      const StepKind kind{.name = "sway", .memory_bytes = one_in(4) ? count() : 64, .run = one_in(4) ? nullptr : sway};
      // A step without memory would write to none.
      if (kind.memory_bytes < 1) return;
      if (const auto step = crowd_->add_step(character_id(), kind); step) steps_.push_back(*step);
      return;
    }
    default:
      static_cast<void>(crowd_->palette_bytes(character_id()));
      static_cast<void>(crowd_->character(character_id()).clip(clip()));
      static_cast<void>(character_.bone_name(index()));
      static_cast<void>(character_.palette_entries(index()));
  }
}

// Nothing may depend on the order in which characters are made, so all of them stay for later calls.
void RandomCalls::call_clips() {
  if (made_characters_.size() > 60) made_characters_.erase(made_characters_.begin() + 1, made_characters_.begin() + 30);
  const Character from = one_in(2) ? known_character() : crowd_->character(character_id());
  switch (below(4)) {
    case 0:
      if (auto made = from.without(clip()); made) made_characters_.push_back(*made);
      return;
    case 1:
      if (auto made = from.with_clips(one_in(10) ? Character() : known_character()); made) {
        made_characters_.push_back(*made);
      }
      return;
    case 2:
      static_cast<void>(from.has(clip()));
      static_cast<void>(from.clip(clip()));
      static_cast<void>(from.find_clip("walk"));
      return;
    default:
      static_cast<void>(crowd_->replace(character_id(), one_in(10) ? Character() : known_character()));
  }
}

void RandomCalls::call_agent() {
  const std::array<BlendPoint, 3> line{BlendPoint{clip(), number()}, BlendPoint{clip(), number()},
                                       BlendPoint{clip(), number(), static_cast<Pace>(below(3))}};
  const std::array<BlendPoint2d, 3> plane{BlendPoint2d{clip(), number(), number()},
                                          BlendPoint2d{clip(), number(), number()},
                                          BlendPoint2d{clip(), number(), number()}};
  switch (below(11)) {
    case 10:
      return call_machine();
    case 0:
    case 1:
      agent().play(play());
      return;
    case 2:
      agent().play(channel(), play());
      return;
    case 3:
      agent().set_speed(static_cast<double>(number()));
      return;
    case 4:
      static_cast<void>(one_in(2) ? agent().add_slot(layer()) : agent().add_clips(layer()));
      return;
    case 5:
      static_cast<void>(agent().add(BlendSpace{std::span(line).first(below(4)), number(), one_in(2)}, layer()));
      return;
    case 6:
      static_cast<void>(agent().add(
          BlendSpace2d{std::span(plane).first(below(4)), static_cast<PlaneMeaning>(below(3)), number(), number()},
          layer()));
      return;
    case 7:
      agent().set_parameter(channel(), number());
      agent().set_parameters(channel(), number(), number());
      return;
    case 8:
      agent().set_weight(channel(), number(), one_in(2) ? time() : Ticks{});
      agent().play_once(channel(), {clip(), time(), time(), static_cast<double>(number()), one_in(2)});
      return;
    default:
      agent().remove(channel());
  }
}

void RandomCalls::call_machine() {
  if (one_in(4)) static_cast<void>(agent().add(one_in(20) ? StateMachine() : machine_, layer()));
  const Machine machine(agent(), channel());
  machine.set(below(5) == 0 ? count() : below(3), number());
  static_cast<void>(machine_.state_name(machine.state()));
  static_cast<void>(machine.entered_at());
}

void RandomCalls::call_motion() {
  const Motion motion = agent().motion();
  const Ticks now = crowd_->clock();
  const Ticks from = one_in(4) ? time() : now - ticks_per_second / 60;
  const Ticks to = one_in(4) ? time() : now;
  static_cast<void>(motion.displacement(from, to));
  static_cast<void>(motion.absolute_root());
  static_cast<void>(motion.curve(count()));
  static_cast<void>(motion.morph_weights({}));
  motion.for_each_key(
      from, to, [](const DataKey&) {}, static_cast<KeyChoice>(below(3)));
  motion.for_each_end(from, to, [](const ClipEnd&) {});
}

void RandomCalls::call_lod() {
  positions_.resize(one_in(8) ? below(20) : crowd_->number_limit());
  for (Vec3& position : positions_) position = vector();
  LodFrame frame{.positions = positions_, .frame_step = one_in(4) ? time() : ticks_per_second / 60};
  frame.camera.position = one_in(4) ? vector() : Vec3{};
  frame.rules.rule = static_cast<LodRule>(below(3));
  if (one_in(4)) {
    frame.camera.pixels_per_unit = number();
    frame.rules.error_pixels = number();
    frame.rules.budget_milliseconds = static_cast<double>(number());
    frame.rules.full_rate_distance = number();
    frame.rules.interval_growth = number();
    frame.rules.largest_interval = index();
    frame.rules.smooth = one_in(2);
  }
  if (one_in(8)) lod_ = Lod(lod_);
  lod_.select(*crowd_, frame);
  crowd_->update(lod_.requests());
  lod_.settle(*crowd_);
  lod_.make_due(agent_id());
  static_cast<void>(lod_.is_visible(agent_id()));
}

std::size_t RandomCalls::pose_all() {
  std::size_t stride = 1;
  for (const CharacterId id : known_characters_) stride = std::max(stride, crowd_->palette_bytes(id) / sizeof(Line));
  std::size_t joints = 1;
  for (const CharacterId id : known_characters_) joints = std::max(joints, (crowd_->joint_bytes(id) + 63) / 64);
  lines_.assign((stride + joints) * crowd_->number_limit(), Line{});
  requests_.clear();
  for (const AgentId id : crowd_->agents()) {
    Line* const lines = &lines_[id.number * (stride + joints)];
    const bool lists = crowd_->joint_bytes(crowd_->agent(id).character()) > 0;
    requests_.push_back({.agent = id,
                         .palette = one_in(4) ? nullptr : reinterpret_cast<std::byte*>(lines->floats),
                         .joints = lists ? reinterpret_cast<std::byte*>(lines[stride].floats) : nullptr});
  }
  static_cast<void>(crowd_->configure({.pus = 2}));  // in matrices
  crowd_->advance(ticks_per_second / 60);
  crowd_->update(requests_);
  std::size_t bad = 0;
  for (const Line& line : lines_) {
    for (const float one : line.floats) bad += !std::isfinite(one);
  }
  return bad;
}

}  // namespace throng::api_test
