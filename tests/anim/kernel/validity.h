#pragma once

#include <initializer_list>

#include <gtest/gtest.h>

namespace throng::anim {

/// One row of a validity table: a change of a valid job, and whether the job is valid after it.
template <class Job>
struct ValidityRow {
  bool valid;
  const char* what;
  void (*change)(Job& job);
};

/// Checks that `job` is valid, and that each change of it alone has the effect that its row says.
template <class Job>
void expect_validity(const Job& job, std::initializer_list<ValidityRow<Job>> rows) {
  EXPECT_TRUE(is_valid(job));
  for (const ValidityRow<Job>& row : rows) {
    Job changed = job;
    row.change(changed);
    EXPECT_EQ(is_valid(changed), row.valid) << row.what;
  }
}

}  // namespace throng::anim
