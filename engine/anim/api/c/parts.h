#pragma once

#include <new>
#include <string>
#include <utility>
#include <vector>

#include "throng/c.h"
#include "throng/throng.h"

#include "engine/anim/base/misuse.h"

// A pointer of throng/c.h points to one of these.
struct throng_file {
  throng::LoadedFile loaded;
};

struct throng_character {
  throng::Character own;
  std::vector<std::string> clip_names = {};  // views of C++ have no zero at their end
  std::vector<std::string> bone_names = {};
};

struct throng_machine {
  throng::StateMachine own;
};

struct throng_crowd {
  throng::Crowd own;
  std::vector<throng::PoseRequest> requests = {};
  std::vector<throng::GazeRequest> gazes = {};
};

struct throng_snapshot {
  throng::Snapshot own;
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

/// A call of throng/c.h that fails if the library notes a misuse meanwhile.
class Call {
 public:
  explicit Call(const char* name) : name_(name) {}

  bool is_missing(const auto*... pointers) const { return c::is_missing(name_, pointers...); }
  /// Returns whether the call went well until now; else keeps why it did not.
  bool went_well(bool ok = true) const {
    if (ok && misuses_.reason().empty()) return true;
    fail(std::string(name_) + ": " +
         (misuses_.reason().empty() ? "there is no room for what it asks for" : misuses_.reason()));
    return false;
  }
  int outcome(bool ok = true) const { return went_well(ok) ? done : failed; }

 private:
  const char* name_;
  anim::MisuseListener misuses_;
};

inline int outcome(const Status& status) { return status ? done : fail(status.error().message); }

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

inline Vec3 vector_of(const float v[3]) { return {v[0], v[1], v[2]}; }

inline void write(const Vec3& v, float out[3]) {
  out[0] = v.x;
  out[1] = v.y;
  out[2] = v.z;
}

// Agents are read through a crowd that no function changes.
inline Agent agent_of(const throng_crowd* crowd, throng_id id) { return {crowd->own.parts(), agent_id(id)}; }

/// Makes something, or says that there is no memory for it.
template <typename Made, typename... Parts>
Made* make(Parts&&... parts) {
  Made* const made = new (std::nothrow) Made{std::forward<Parts>(parts)...};
  if (made == nullptr) fail("there is no memory left");
  return made;
}

}  // namespace throng::c
