#include "app/window/selection_log.h"

#include "app/show/stage/stage.h"
#include "engine/base/text/joined.h"

namespace throng::app {

void SelectionLog::begin(const Stage& stage, const SelectionReport& selected) {
  agent_ = selected.agent;
  crowd_ = stage.animated().number();
  seen_until_ = stage.system().clock();
  clip_ = stage.crowd().minds().clips()[agent_];
  history_.clear();
  events_.clear();
}

void SelectionLog::note(double seconds, const std::string& what) {
  events_.push_front(fixed(seconds, 2) + " s  " + what);
  if (events_.size() > most_events) events_.pop_back();
}

void SelectionLog::note_data_keys(const Stage& stage) {
  const anim::Character& character = *stage.character_of(agent_).character;
  const auto tell = [&](const anim::DataKeyEvent& event) {
    note(to_seconds(event.time), character.data_key_names[event.name] + " of " + character.clips[event.clip].name);
  };
  stage.system().agent(agent_).motion().for_each_data_key(seen_until_, stage.system().clock(), tell);
}

void SelectionLog::note_clip(const Stage& stage) {
  const int clip = stage.crowd().minds().clips()[agent_];
  if (clip == clip_) return;
  clip_ = clip;
  if (clip == no_clip) return;
  const std::string& name = stage.character_of(agent_).character->clips[static_cast<std::size_t>(clip)].name;
  note(to_seconds(stage.system().clock()), "begins " + name);
}

void SelectionLog::update(const Stage& stage, SelectionReport& selected) {
  const Ticks now = stage.system().clock();
  if (selected.agent != agent_ || stage.animated().number() != crowd_ || now < seen_until_) begin(stage, selected);
  if (now > seen_until_) {
    note_data_keys(stage);
    note_clip(stage);
    seen_until_ = now;
    history_.push_back({selected.visible, static_cast<std::uint8_t>(selected.interval),
                        static_cast<std::uint8_t>(selected.bone_level)});
    if (history_.size() > most_frames) history_.pop_front();
  }
  selected.history.assign(history_.begin(), history_.end());
  selected.events.assign(events_.begin(), events_.end());
}

}  // namespace throng::app
