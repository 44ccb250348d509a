#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/lod/lod.h"

namespace throng::app {

/// Lends post processes of one type to the few agents that need one at a time. All other agents are posed without one,
/// and a frame allocates nothing. A class that derives from it says when an agent gets one, and what it does.
template <typename Process>
class LentProcesses {
 public:
  /// All state that changes as time passes.
  struct Moment {
    std::vector<ProcessId> of;         ///< [agent] invalid: none
    std::vector<std::uint8_t> wanted;  ///< [agent] 1: it has a process that was not let go
    std::vector<std::uint32_t> have;   ///< agents that have a process
  };

  /// Takes the kind of entity of each character; it is empty for a character that cannot have the process. `system`
  /// outlives this.
  LentProcesses(std::vector<std::optional<anim::EntityPools::Kind>> kinds, anim::AnimationSystem& system)
      : kinds_(std::move(kinds)), not_lent_(kinds_.size()), system_(&system) {}

  /// Forgets all agents and makes room for `agents`; call it when they are made anew.
  void reset(std::size_t agents) {
    constexpr std::size_t usually_near_by = 256;  // agents of one character
    now_.of.assign(agents, {});
    now_.wanted.assign(agents, 0);
    now_.have.clear();
    now_.have.reserve(agents);
    const std::size_t usual = std::min(agents, usually_near_by);
    for (std::uint32_t character = 0; character < kinds_.size(); ++character) {
      if (!kinds_[character]) continue;
      system_->characters().reserve_entities(*kinds_[character], usual, character);
      while (not_lent_[character].size() < usual) not_lent_[character].push_back(make_new(character));
    }
  }

  /// Takes the process from agents whose effect has faded, or that are not in `visible`, which ascends by agent. An
  /// agent keeps it while another post process comes after it. Call it before an update.
  void take_back(std::span<const anim::VisibleAgent> visible) {
    std::erase_if(now_.have, [&](std::uint32_t agent) {
      if (needs(agent, visible)) return false;
      std::unique_ptr<Process> process = system_->agent(agent).template take_post_process<Process>(now_.of[agent]);
      std::vector<std::unique_ptr<Process>>& ready = not_lent_[system_->agent(agent).character_number()];
      if (ready.size() < ready.capacity()) ready.push_back(std::move(process));
      now_.of[agent] = {};
      now_.wanted[agent] = 0;
      return true;
    });
  }

  const Moment& moment() const { return now_; }
  void go_back_to(const Moment& moment) { now_ = moment; }

 protected:
  enum class Lent : std::uint8_t { no, anew, again, still };
  /// Lends a process to an agent, if it has none. `make` returns it as it begins, of a kind. The answer: whether it was
  /// lent now, had been let go, or neither; `no` where a local store has no room for it, which has none for others.
  template <typename Make>
  Lent lend(std::uint32_t agent, Make make) {
    if (now_.of[agent].valid()) {
      return std::exchange(now_.wanted[agent], std::uint8_t{1}) == 0 ? Lent::again : Lent::still;
    }
    const std::uint32_t character = system_->agent(agent).character_number();
    if (!kinds_[character]) return Lent::no;
    std::unique_ptr<Process> process = take_ready(character);
    *process = make(*kinds_[character]);
    const Result<ProcessId> added = system_->agent(agent).add_post_process(std::move(process));
    if (!added) {
      kinds_[character].reset();
      return Lent::no;
    }
    now_.of[agent] = *added;
    now_.wanted[agent] = 1;
    now_.have.push_back(agent);
    return Lent::anew;
  }

  /// Changes the process of an agent that has one.
  template <typename Change>
  void change(std::uint32_t agent, Change change) {
    [[maybe_unused]] const Status changed =
        system_->agent(agent).template change_process<Process>(now_.of[agent], change);
    assert(changed && "the graph is as large as it was");
  }
  /// Lets the process of an agent fade to no effect, if it has a process that was not let go.
  void let_go(std::uint32_t agent, Ticks fade) {
    if (std::exchange(now_.wanted[agent], std::uint8_t{0}) == 0) return;
    change(agent, [fade](Process& process) { process.set_weight(0.0F, fade); });
  }

 private:
  bool needs(std::uint32_t agent, std::span<const anim::VisibleAgent> visible) const {
    const anim::AgentView posed = std::as_const(*system_).agent(agent);
    if (now_.of[agent] != posed.post_process_id(posed.post_process_count() - 1)) return true;  // a rag-doll came after
    if (!std::ranges::binary_search(visible, agent, {}, &anim::VisibleAgent::agent)) return false;
    return now_.wanted[agent] != 0 ||
           posed.template post_process<Process>(now_.of[agent])->weight(posed.pools()) > 0.0F;
  }
  std::unique_ptr<Process> make_new(std::uint32_t character) const {
    if constexpr (std::is_constructible_v<Process, anim::EntityPools::Kind>) {
      return std::make_unique<Process>(*kinds_[character]);
    } else {
      return std::make_unique<Process>(*kinds_[character], typename Process::Settings{});
    }
  }
  std::unique_ptr<Process> take_ready(std::uint32_t character) {
    std::vector<std::unique_ptr<Process>>& ready = not_lent_[character];
    if (ready.empty()) return make_new(character);
    std::unique_ptr<Process> one = std::move(ready.back());
    ready.pop_back();
    return one;
  }

  std::vector<std::optional<anim::EntityPools::Kind>> kinds_;    // [character]
  std::vector<std::vector<std::unique_ptr<Process>>> not_lent_;  // [character]
  anim::AnimationSystem* system_;
  Moment now_;
};

}  // namespace throng::app
