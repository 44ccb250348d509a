#include "app/window/frame_rate_keeper.h"

#include <algorithm>
#include <vector>

#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

constexpr std::size_t settling_frames = 2;               // after a change: targets are made anew, and meshes change
constexpr double too_slow = 1.06, time_to_spare = 0.72;  // of the time of a frame
constexpr double slow_enough_to_say = 1.5;               // times the time of a frame
constexpr double least_patience = 2.0, most_patience = 60.0;  // seconds

/// Returns how many costs lower a frame must be that takes so many times its time.
std::size_t steps_down(double times) { return times > 3.0 ? 4 : times > 2.0 ? 3 : times > 1.4 ? 2 : 1; }

template <std::size_t count>
double median(std::array<double, count> numbers) {
  const auto middle = numbers.begin() + count / 2;
  std::ranges::nth_element(numbers, middle);
  return *middle;
}

}  // namespace

void FrameRateKeeper::go_to(std::size_t cost) {
  went_up_ = cost < cost_;
  cost_ = cost;
  frames_ = 0;
  seconds_ = 0.0;
}

bool FrameRateKeeper::knows_times() const { return frames_ >= settling_frames + last_.size(); }

double FrameRateKeeper::times(const Tuning& asked) const {
  return median(last_) * static_cast<double>(asked.frame_rate) / 1000.0;
}

void FrameRateKeeper::add_frame(double milliseconds, const Tuning& asked) {
  last_.at(frames_++ % last_.size()) = milliseconds;
  seconds_ += std::max(milliseconds / 1000.0, 1.0 / static_cast<double>(asked.frame_rate));
  if (!asked.holds_rate && cost_ != first_) go_to(first_);
  if (!asked.holds_rate || !knows_times()) return;
  const double times = this->times(asked);
  patience_ = std::max(patience_, least_patience);
  if (times > too_slow && cost_ + 1 < picture_costs.size()) {
    patience_ = went_up_ && seconds_ < most_patience ? std::min(2.0 * patience_, most_patience) : least_patience;
    go_to(std::min(cost_ + steps_down(times), picture_costs.size() - 1));
  } else if (times < time_to_spare && cost_ > 0 && seconds_ > patience_) {
    go_to(cost_ - 1);
  }
}

Tuning FrameRateKeeper::kept(Tuning asked) const {
  if (!asked.holds_rate) return asked;
  set_cost(asked, by_hand_or(picture_costs[cost_], asked));
  return asked;
}

PictureCost FrameRateKeeper::by_hand_or(PictureCost cost, const Tuning& asked) const {
  if (by_hand_.picture_size) cost.picture_size = asked.picture_size;
  if (by_hand_.triangle_budget) cost.triangle_budget = asked.triangle_budget;
  if (by_hand_.shadows) cost.shadows = asked.shadows;
  if (by_hand_.crowd_shade) cost.crowd_shade = asked.crowd_shade;
  return cost;
}

Tuning FrameRateKeeper::at_best(Tuning asked) const {
  const PictureCost best = picture_costs.front();
  PictureCost cost = quality_of(asked).empty() ? cost_of(asked) : best;
  if (asked.holds_rate) cost = by_hand_or(cost, asked);
  cost.picture_size = best.picture_size;
  set_cost(asked, cost);
  asked.holds_rate = false;
  return asked;
}

Tuning FrameRateKeeper::changed(Tuning by_person, const Tuning& asked) {
  const PictureCost shown = cost_of(kept(asked));
  if (by_person.holds_rate && !asked.holds_rate) by_hand_ = {};
  if (!by_person.holds_rate || !asked.holds_rate) return by_person;
  const auto settle = [](auto& value, const auto& was_shown, const auto& was_asked, bool& by_hand) {
    if (value != was_shown) by_hand = true;
    if (!by_hand) value = was_asked;
  };
  settle(by_person.picture_size, shown.picture_size, asked.picture_size, by_hand_.picture_size);
  settle(by_person.triangle_budget, shown.triangle_budget, asked.triangle_budget, by_hand_.triangle_budget);
  settle(by_person.shadows, shown.shadows, asked.shadows, by_hand_.shadows);
  settle(by_person.crowd_shade, shown.crowd_shade, asked.crowd_shade, by_hand_.crowd_shade);
  return by_person;
}

std::string FrameRateKeeper::given_up(const Tuning& asked) const {
  if (!asked.holds_rate) return {};
  const PictureCost best = picture_costs.front(), cost = cost_of(kept(asked));
  std::vector<std::string> parts;
  if (cost.picture_size < best.picture_size && !by_hand_.picture_size) {
    parts.push_back("the picture has " + std::to_string(cost.picture_size) + "% of the window's size");
  }
  if (cost.triangle_budget > 0 && !by_hand_.triangle_budget) {
    parts.push_back(counted(static_cast<std::size_t>(cost.triangle_budget), "triangle"));
  }
  if (!cost.shadows && !by_hand_.shadows) parts.emplace_back("no shadows");
  if (!cost.crowd_shade && !by_hand_.crowd_shade) parts.emplace_back("no crowd shade");
  if (parts.empty()) return {};
  return "To show " + std::to_string(static_cast<int>(asked.frame_rate)) + " frames a second: " + joined(parts) + ".";
}

std::string FrameRateKeeper::advice(const Tuning& asked) const {
  if (asked.holds_rate || !knows_times() || times(asked) < slow_enough_to_say) return {};
  const std::string rate = std::to_string(static_cast<int>(asked.frame_rate));
  return std::string(is_slow_ ? "No graphics card: the processor draws. " : "") + "A frame takes " +
         std::to_string(static_cast<int>(median(last_))) + " ms; quality auto shows up to " + rate + " a second.";
}

}  // namespace throng::app
