#include "engine/tracks/live/live_crowd.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/tracks/presence.h"

namespace throng {
namespace {

constexpr double least_delay = 0.5, most_delay = 10.0;  // seconds
constexpr double rows_of_delay = 2.05;                  // a curve between two rows goes by the one after them
constexpr double most_playback_rate = 3.0, least_playback_rate = 0.05;
constexpr double input_rate_window = 2.0;         // seconds
constexpr double steady_input = 1.5;              // faster input is no camera; the clock does not hurry after it
constexpr double row_seconds_share = 1.0 / 16.0;  // of a new row in the mean
constexpr std::size_t least_rows = 4;             // of a person, that are kept before the clock

std::string one_or_many(std::size_t count, const std::string& one, const std::string& many) {
  return count == 1 ? one : std::to_string(count) + many;
}

}  // namespace

double live_rate(double behind, double row_seconds, double delay, bool catches_up) {
  if (behind < 0.0) return std::max(1.0 + behind / (0.5 * delay), 0.0);
  return catches_up && behind > row_seconds ? std::min(1.0 + behind - row_seconds, most_playback_rate) : 1.0;
}

LiveCrowd::LiveCrowd(std::unique_ptr<LiveTracks> tracks, std::size_t places, GroundPlan plan, Pace pace)
    : tracks_(std::move(tracks)),
      all_(std::make_shared<Trajectories>()),
      pace_(pace),
      person_at_(places, none),
      is_changed_(places, 0) {
  const LiveHead head = tracks_->head().value_or(LiveHead());
  all_->persons.resize(places);
  all_->plan = std::move(plan);
  all_->origin = head.origin;
  all_->file = "-";
  all_->reading = head.reading;
  all_->format = head.format;
  all_->remarks = head.remarks;
  all_->is_live = true;
  for (std::uint32_t place = 0; place < places; ++place) free_.push_back(place);
  fetch();
  if (!waiting_.empty()) seconds_ = waiting_.front().row.seconds;
  all_->first_seconds = all_->last_seconds = seconds_;
}

double LiveCrowd::delay() const { return std::clamp(rows_of_delay * row_seconds_, least_delay, most_delay); }

// Rows stay where they are while many wait, so that their sender waits too.
void LiveCrowd::fetch() {
  if (has_read_all_ || waiting_.size() - next_ >= LiveTracks::most_waiting_rows) return;
  if (next_ >= waiting_.size() / 2) {  // so that a row is moved once or twice
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(std::exchange(next_, 0)));
  }
  const std::size_t before = waiting_.size();
  has_read_all_ = !tracks_->take(waiting_);
  const bool is_first = all_->row_count == 0 && before == 0 && !waiting_.empty();
  if (is_first) newest_ = newest_before_ = waiting_.front().row.seconds;
  for (std::size_t i = before; i < waiting_.size(); ++i) {
    const LiveRow& row = waiting_[i];
    newest_ = std::max(newest_, row.row.seconds);
    if (row_seconds_ > 0.0) continue;
    constexpr double never = -std::numeric_limits<double>::infinity();
    if (row.person >= last_seconds_.size()) last_seconds_.resize(row.person + 1, never);
    const double last = std::exchange(last_seconds_[row.person], row.row.seconds);
    if (last > never) row_seconds_ = row.row.seconds - last;
  }
}

bool LiveCrowd::can_go_on(double seconds, std::chrono::milliseconds most) {
  const auto has_rows = [&] {
    return has_read_all_ || waiting_.size() - next_ >= LiveTracks::most_waiting_rows ||
           (row_seconds_ > 0.0 && newest_ > seconds_ + seconds + delay());
  };
  fetch();
  if (has_rows()) return true;
  tracks_->wait(most);
  fetch();
  return has_rows();
}

// Hurries only behind a camera: rows that come faster than they are shown are from a file, which cannot be late.
double LiveCrowd::rate(double seconds) {
  if (seconds <= 0.0) return 1.0;
  const double share = std::min(seconds / input_rate_window, 1.0);
  input_rate_ += share * ((newest_ - newest_before_) / seconds - input_rate_);
  newest_before_ = newest_;
  if (pace_ == Pace::of_the_run || has_read_all_) return 1.0;
  const bool is_full = waiting_.size() - next_ >= LiveTracks::most_waiting_rows;
  return live_rate(newest_ - delay() - seconds_, row_seconds_, delay(), !is_full && input_rate_ < steady_input);
}

LiveStep LiveCrowd::advance(double seconds) {
  for (const std::uint32_t place : changed_) is_changed_[place] = 0;
  changed_.clear();
  fetch();
  const double before = seconds_, rate_now = rate(seconds);
  free_places();
  const double next = std::max(before, std::min(before + seconds * rate_now, newest_));
  hand_out(next + delay());
  all_->last_seconds = newest_;
  all_->first_seconds = std::max(all_->first_seconds, before - kept_seconds);
  if (row_seconds_ > 0.0) all_->rows_a_second = 1.0 / row_seconds_;
  let_stand(seconds, next > before + least_playback_rate * seconds);
  seconds_ = next;
  const double settled = has_begun_ ? before : -std::numeric_limits<double>::infinity();
  has_begun_ = has_begun_ || next > before;
  return {.clock = {.seconds = before,
                    .first = all_->first_seconds,
                    .last = newest_,
                    .rate = seconds > 0.0 ? (next - before) / seconds : 1.0,
                    .stands = stands_},
          .settled = settled,
          .changed = changed_};
}

void LiveCrowd::let_stand(double seconds, bool goes_on) {
  constexpr double to_stand = 0.7, to_go_on = 0.3;  // seconds
  if (pace_ == Pace::of_the_run) return;
  const double share = goes_on ? -seconds / to_go_on : seconds / to_stand;
  stands_ = std::clamp(stands_ + static_cast<float>(share), 0.0F, 1.0F);
}

void LiveCrowd::free_places() {
  for (std::uint32_t place = 0; place < person_at_.size(); ++place) {
    if (person_at_[place] == none) continue;
    if (presence_of(all_->persons[place], row_seconds_).last >= seconds_) continue;
    person_at_[place] = none;
    free_.push_back(place);
  }
}

void LiveCrowd::hand_out(double until) {
  for (; next_ < waiting_.size() && waiting_[next_].row.seconds <= until; ++next_) take(waiting_[next_]);
}

void LiveCrowd::take(const LiveRow& row) {
  if (row.person >= place_of_.size()) {
    place_of_.resize(row.person + 1, none);
    had_no_place_.resize(row.person + 1, 0);
  }
  std::uint32_t& place = place_of_[row.person];
  if (place != none && person_at_[place] == row.person) {
    go_on(all_->persons[place].rows, row.row);
  } else if (row.row.seconds < seconds_) {
    ++late_rows_;
    return;
  } else if (free_.empty()) {
    if (std::exchange(had_no_place_[row.person], 1) == 0) ++without_place_;
    return;
  } else {
    place = free_place(place);
    begin_track(place, row);
  }
  ++all_->row_count;
  mark(place);
}

/// A person who comes back gets the place of before while it is free.
std::uint32_t LiveCrowd::free_place(std::uint32_t before) {
  const auto same = before != none ? std::ranges::find(free_, before) : free_.end();
  const auto chosen = same != free_.end() ? same : free_.begin();
  const std::uint32_t place = *chosen;
  free_.erase(chosen);
  return place;
}

void LiveCrowd::go_on(std::vector<TrackRow>& rows, const TrackRow& row) {
  row_seconds_ += row_seconds_share * (row.seconds - rows.back().seconds - row_seconds_);
  forget_old_rows(rows);
  rows.push_back(row);
}

void LiveCrowd::begin_track(std::uint32_t place, const LiveRow& row) {
  person_at_[place] = row.person;
  PersonTrack& track = all_->persons[place];
  track.id = tracks_->id(row.person);
  track.stature = row.stature;
  track.rows.assign(1, row.row);
}

void LiveCrowd::forget_old_rows(std::vector<TrackRow>& rows) const {
  constexpr std::size_t lot = 64;  // so that rows are seldom moved
  std::size_t old = 0;
  while (old + least_rows < rows.size() && rows[old + least_rows].seconds < seconds_ - kept_seconds) ++old;
  if (old >= lot || (old > 0 && old > rows.size() / 2)) {
    rows.erase(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(old));
  }
}

void LiveCrowd::mark(std::uint32_t place) {
  if (std::exchange(is_changed_[place], 1) == 0) changed_.push_back(place);
}

Status LiveCrowd::status() const {
  if (Status read = tracks_->status(); !read) return read;
  if (!has_ended() || late_rows_ <= all_->row_count) return Done{};
  return Error{"-: " + std::to_string(late_rows_) + " of " + std::to_string(late_rows_ + all_->row_count) +
               " rows came too late to be shown; send rows in the order of time, or name the file instead of -"};
}

std::vector<std::string> LiveCrowd::remarks() const {
  std::vector<std::string> sentences;
  const auto say = [&](std::size_t count, const std::string& one, const std::string& many, const std::string& rest) {
    if (count > 0) sentences.push_back("-: " + one_or_many(count, one, many) + rest);
  };
  const Status read = status();
  if (!read) {
    sentences.push_back(read.error().message + ". The crowd stays as it was until then.");
  } else if (has_ended() && pace_ == Pace::of_the_rows) {
    sentences.emplace_back("-: The input has ended, and the crowd stays as it was at its last row.");
  }
  say(without_place_, "One person found no place", " people found no place",
      " among the " + std::to_string(person_at_.size()) + "; --agents makes more.");
  say(read ? late_rows_ : 0, "One row", " rows",
      " came too late to be shown; send rows in the order of time, or name the file instead of -.");
  say(tracks_->late_rows(), "One row was", " rows were",
      " left out, for the person has one of that time or later; send rows in the order of time.");
  say(tracks_->bad_rows(), "One wrong row was", " wrong rows were", " skipped.");
  return sentences;
}

std::size_t LiveCrowd::news() const {
  const std::size_t ends = (has_ended() ? 1U : 0U) + (tracks_->status() ? 0U : 1U);
  return ends + without_place_ + late_rows_ + tracks_->late_rows() + tracks_->bad_rows();
}

}  // namespace throng
