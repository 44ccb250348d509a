#include "app/output/workers.h"

#include <string>
#include <utility>

#include "app/files/exit_status.h"

namespace throng::app {

Workers::Workers(int threads, std::size_t most_waiting) : most_waiting_(most_waiting) {
  for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
}

Workers::~Workers() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
    waiting_.clear();
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

Status Workers::add(Job job) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return waiting_.size() < most_waiting_ || !outcome_; });
  if (!outcome_) return outcome_;
  waiting_.push_back(std::move(job));
  lock.unlock();
  changed_.notify_all();
  return Done{};
}

Status Workers::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return waiting_.empty() && at_work_ == 0; });
  return outcome_;
}

void Workers::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return ends_ || !waiting_.empty(); });
    if (ends_) return;
    const Job job = std::move(waiting_.front());
    waiting_.pop_front();
    ++at_work_;
    lock.unlock();
    changed_.notify_all();
    Status outcome = done(job);
    lock.lock();
    --at_work_;
    if (!outcome && outcome_) {
      outcome_ = std::move(outcome);
      waiting_.clear();
    }
    changed_.notify_all();
  }
}

// An exception that left a thread would end the program at once.
Status Workers::done(const Job& job) {
  try {
    return job();
  } catch (...) {
    return Error{std::string(sentence_of_failure())};
  }
}

}  // namespace throng::app
