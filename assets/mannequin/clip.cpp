#include "assets/mannequin/clip.h"

#include <utility>

namespace throng::mannequin {

Clip sample_loop(std::string name, std::size_t frames, double speed, const std::function<Pose(double phase)>& motion) {
  Clip clip{std::move(name), {}};
  for (std::size_t frame = 0; frame <= frames; ++frame) {
    const double phase = static_cast<double>(frame % frames) / static_cast<double>(frames);
    Pose pose = motion(phase);
    pose.root.z += speed * static_cast<double>(frame) / key_rate;
    clip.keys.push_back(pose);
  }
  return clip;
}

std::vector<Clip> make_clips() {
  return {make_idle(), make_walk(), make_cheer(), make_wave(), make_clap(), make_jog(), make_run()};
}

}  // namespace throng::mannequin
