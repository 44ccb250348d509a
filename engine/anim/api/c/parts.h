#pragma once

#include <bit>
#include <cmath>
#include <deque>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "throng/c.h"
#include "throng/throng.h"

#include "engine/anim/api/c/sized.h"
#include "engine/anim/base/misuse.h"

// A pointer of throng/c.h points to one of these.
struct throng_file {
  throng::LoadedFile loaded;
};

struct throng_character {
  throng::Character own;
};

struct throng_builder {
  throng::CharacterBuilder own;
};

struct throng_machine {
  throng::StateMachine own;
};

namespace throng::c {

/// A step of a host in C, with the name that StepKind points to.
struct HostStep {
  throng_step own;
  std::string name;
  StepId id = {};
};

}  // namespace throng::c

struct throng_crowd {
  std::unique_ptr<throng::Executor> executor;  // the first member, since the crowd ends before it
  throng::Crowd own;
  std::deque<throng::c::HostStep> steps = {};
  std::vector<throng::PoseRequest> requests = {};
  std::vector<throng::GazeRequest> gazes = {};
};

struct throng_snapshot {
  throng::Snapshot own;
};

struct throng_lod {
  throng::Lod own;
  std::vector<throng_pose_request> requests = {};
};

namespace throng::c {

using namespace throng;

inline constexpr int done = 0;
inline constexpr int failed = 1;

/// Keeps why a call of this thread failed, and returns `failed`.
int fail(std::string why);

/// Reports a call with a null pointer as any other misuse.
bool is_missing(const char* call, const auto*... pointers) {
  if (((pointers != nullptr) && ...)) return false;
  anim::report_misuse({call, "a pointer is null"});
  fail(std::string(call) + ": a pointer is null");
  return true;
}

/// Returns a struct of throng/c.h with the defaults of the headers for C++. Its size is not set.
template <typename C>
C default_of();

/// A call of throng/c.h that fails if the library notes a misuse meanwhile.
class Call {
 public:
  explicit Call(const char* name) : name_(name) {}

  bool is_missing(const auto*... pointers) const { return c::is_missing(name_, pointers...); }
  /// Returns whether an array that has elements is null. An empty one may be.
  bool lacks(const auto* elements, std::size_t count) const { return count > 0 && is_missing(elements); }
  /// Reports a misuse, and returns false.
  bool refuse(const std::string& reason) const {
    anim::report_misuse({name_, reason.c_str()});
    return went_well();
  }
  /// Returns whether `value` is a constant of an enumeration that ends with `last`; else reports a misuse.
  template <typename Enum>
  bool is_constant(const char* member, std::uint32_t value, Enum last) const {
    return value <= static_cast<std::uint32_t>(last) || refuse(std::string(member) + " is none of its constants");
  }
  /// Returns the options that `given` has, and the defaults for null. Returns nothing, after a report, if its size is
  /// not one that `name` has had.
  template <typename C>
  std::optional<C> read(const char* name, const C* given) const {
    if (given == nullptr) return default_of<C>();
    if (is_known_size<C>(given->size)) return completed(given, default_of<C>());
    refuse("the size of a " + std::string(name) + " is wrong; begin with " + name + "_default()");
    return std::nullopt;
  }
  /// Returns whether the call went well until now; else keeps why it did not.
  bool went_well(bool ok = true) const {
    if (ok && misuses_.reason().empty()) return true;
    fail(std::string(name_) + ": " +
         (misuses_.reason().empty() ? "there is no room for what it asks for" : misuses_.reason()));
    return false;
  }
  int outcome(bool ok = true) const { return went_well(ok) ? done : failed; }
  /// Returns an answer; its zero, with the reason kept, if the call did not go well.
  template <typename Answer>
  Answer answer(Answer value) const {
    return went_well() ? value : Answer{};
  }
  int yes_or_no(bool yes) const { return went_well() && yes ? 1 : 0; }

 private:
  const char* name_;
  anim::MisuseListener misuses_;
};

/// Writes the defaults of a struct. One of a size that this version does not know becomes 0, so that it is refused.
template <typename C>
int fill(const char* call, C* into, std::size_t size) {
  if (is_missing(call, into)) return failed;
  std::memset(static_cast<void*>(into), 0, size);
  if (!is_known_size<C>(size)) return fail(std::string(call) + ": this version knows no struct of this size");
  C defaults = default_of<C>();
  if constexpr (requires { defaults.size; }) defaults.size = static_cast<std::uint32_t>(size);
  std::memcpy(static_cast<void*>(into), &defaults, size);
  return done;
}

inline int outcome(const Result<Done>& status) { return status ? done : fail(status.error().message); }

template <typename Id>
std::uint32_t number_or_none(const Result<Id>& id) {
  if (id) return id->number;
  fail(id.error().message);
  return THRONG_NONE;
}

inline AgentId agent_id(throng_id id) { return {.number = id.number, .generation = id.generation}; }
inline CharacterId character_id(throng_id id) { return {id.number, id.generation}; }
template <typename Id>
throng_id id_of(Id id) {
  return {.number = id.number, .generation = id.generation};
}

/// Returns a time. NaN becomes one that every call refuses, and not no time at all.
inline Ticks ticks_of(double seconds) { return std::isnan(seconds) ? -longest_time : to_ticks(seconds); }
inline Ticks ticks_of(float seconds) { return ticks_of(static_cast<double>(seconds)); }

inline Vec3 vector_of(const float v[3]) { return {v[0], v[1], v[2]}; }
inline void write(const Vec3& v, float out[3]) { std::memcpy(out, &v, sizeof(v)); }
inline Place place_of(const throng_place& place) { return std::bit_cast<Place>(place); }
inline throng_place c_place_of(const Place& place) { return std::bit_cast<throng_place>(place); }

/// Returns structs of C as those of C++, which have the same layout.
template <typename Cpp, typename C>
std::span<Cpp> as(C* structs, std::size_t count) {
  static_assert(sizeof(Cpp) == sizeof(C));
  static_assert(alignof(Cpp) == alignof(C));
  return {reinterpret_cast<Cpp*>(structs), count};
}

/// Returns an array of C as elements of C++ that have several numbers each, such as three floats as a Vec3. Null: none.
template <typename Cpp, typename Number>
std::span<const Cpp> elements(const Number* numbers, std::size_t count) {
  static_assert(sizeof(Cpp) % sizeof(Number) == 0);
  return {reinterpret_cast<const Cpp*>(numbers), numbers == nullptr ? 0 : count};
}

inline std::string_view view_of(const char* text) { return text == nullptr ? std::string_view() : text; }
/// Returns a name of the headers for C++ for C; null if there is none. It views a whole std::string.
inline const char* text_of(std::string_view name) { return name.data(); }
inline const char* text_at(std::span<const std::string> texts, std::uint32_t index) {
  return index < texts.size() ? texts[index].c_str() : nullptr;
}

/// Returns the options for C++, which point to `rig`. Returns nothing, after a report, if `given` is not whole.
std::optional<LoadOptions> load_options_of(const Call& call, const throng_load_options* given,
                                           std::vector<BoneRole>& rig);

// Agents are read through a crowd that no function changes.
inline Agent agent_of(const throng_crowd* crowd, throng_id id) { return {crowd->own.parts(), agent_id(id)}; }

/// Makes something, or says that there is no memory for it.
template <typename Made, typename... Parts>
Made* make(Parts&&... parts) {
  Made* const made = new (std::nothrow) Made{std::forward<Parts>(parts)...};
  if (made == nullptr) fail("there is no memory left");
  return made;
}

/// Makes something of a result, or keeps why there is none.
template <typename Made, typename Own>
Made* make_of(Result<Own> result) {
  if (result) return make<Made>(std::move(*result));
  fail(result.error().message);
  return nullptr;
}

/// Copies as many answers as there is room for, and returns how many there are.
template <typename Answers, typename C>
std::uint32_t list(const Answers& answers, C* into, std::uint32_t most) {
  static_assert(sizeof(*answers.data()) == sizeof(C));
  const std::size_t count = std::min<std::size_t>(answers.size(), most);
  if (count > 0) std::memcpy(static_cast<void*>(into), answers.data(), count * sizeof(C));
  return static_cast<std::uint32_t>(answers.size());
}

}  // namespace throng::c
