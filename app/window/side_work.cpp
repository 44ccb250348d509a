#include "app/window/side_work.h"

#include <system_error>
#include <utility>

#include "app/files/exit_status.h"

namespace throng::app {

SideWork::SideWork(LongWork work) : work_(std::move(work)) {
  try {
    thread_ = std::thread([this] { run(); });
  } catch (const std::system_error&) {
    run();  // there are no more threads
  }
}

SideWork::~SideWork() {
  give_up();
  if (thread_.joinable()) thread_.join();
}

// An exception that left a thread would end the program at once.
void SideWork::run() {
  Status outcome = Done{};
  try {
    work_([this](double share, const std::string& what) { take(share, what); });
  } catch (const GivenUp&) {
  } catch (...) {
    outcome = Error{std::string(sentence_of_failure())};
  }
  const std::lock_guard lock(mutex_);
  outcome_ = std::move(outcome);
  has_ended_ = true;
}

void SideWork::take(double share, const std::string& what) {
  const std::lock_guard lock(mutex_);
  if (is_given_up_) throw GivenUp{};
  progress_ = {share, what};
}

void SideWork::give_up() {
  const std::lock_guard lock(mutex_);
  is_given_up_ = true;
}

bool SideWork::has_ended() const {
  const std::lock_guard lock(mutex_);
  return has_ended_;
}

SideWork::Progress SideWork::progress() const {
  const std::lock_guard lock(mutex_);
  return progress_;
}

}  // namespace throng::app
