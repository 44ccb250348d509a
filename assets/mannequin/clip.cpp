#include "assets/mannequin/clip.h"

namespace throng::mannequin {

Clip sample(const Motion& motion) {
  Clip clip{motion.name, {}, motion.marks};
  for (std::size_t frame = 0; frame <= motion.frames; ++frame) {
    clip.keys.push_back(motion.pose(static_cast<double>(frame) / static_cast<double>(motion.frames)));
  }
  if (!motion.loops) return clip;
  const Pose end = clip.keys.back();
  clip.keys.back() = clip.keys.front();
  clip.keys.back().root = end.root;
  clip.keys.back()["root"] = end.rotations[0];
  return clip;
}

std::vector<Motion> make_motions() {
  return {make_idle(),
          make_walk(),
          make_cheer(),
          make_wave(),
          make_clap(),
          make_jog(),
          make_run(),
          make_look_around(),
          make_turn(Side::left),
          make_turn(Side::right),
          make_talk(),
          make_sit_down(),
          make_sit(),
          make_stand_up(),
          make_stumble(),
          make_walk_back(),
          make_side_step(Side::left),
          make_side_step(Side::right),
          make_shuffle(),
          make_step_in_place(),
          make_veer(Side::left),
          make_veer(Side::right),
          make_phone(),
          make_call(),
          make_drink(),
          make_take_picture(),
          make_lean(),
          make_sit_on_step(),
          make_carry(),
          make_hold_up(),
          make_hold_phone(),
          make_lead(),
          make_led(),
          make_push(),
          make_stick()};
}

std::vector<Clip> make_clips() {
  std::vector<Clip> clips;
  for (const Motion& motion : make_motions()) clips.push_back(sample(motion));
  return clips;
}

}  // namespace throng::mannequin
