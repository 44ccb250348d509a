#include "engine/anim/run/pu_threads.h"

#include <cassert>

namespace throng::anim {

PuThreads::PuThreads(int pus) {
  threads_.reserve(static_cast<std::size_t>(pus - 1));
  for (int pu = 1; pu < pus; ++pu) threads_.emplace_back([this, pu] { work(pu); });
}

PuThreads::~PuThreads() {
  stopping_.store(true, std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void PuThreads::run(int count, Job job) {
  assert(count >= 1 && static_cast<std::size_t>(count) <= threads_.size() + 1);
  if (count == 1) return job.run(job.context, 0);
  job_ = job;
  count_ = count;
  running_.store(static_cast<int>(threads_.size()), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  job.run(job.context, 0);
  for (int left = running_.load(std::memory_order_acquire); left != 0;
       left = running_.load(std::memory_order_acquire)) {
    running_.wait(left, std::memory_order_acquire);
  }
}

void PuThreads::work(int pu) {
  std::uint32_t seen = 0;
  while (true) {
    round_.wait(seen, std::memory_order_acquire);
    seen = round_.load(std::memory_order_acquire);
    if (stopping_.load(std::memory_order_relaxed)) return;
    if (pu < count_) job_.run(job_.context, pu);
    if (running_.fetch_sub(1, std::memory_order_acq_rel) == 1) running_.notify_one();
  }
}

}  // namespace throng::anim
