// Runs rounds of soak until the time is over; see README.md beside it.
//   throng_soak --minutes M [--first SEED] [--headless] [--tell]
//   throng_soak --seed N [--times K] [--tell]

#include <cstdio>
#include <cstdlib>

#include "tests/soak/soak.h"

int main(int count, char** arguments) {
  using namespace throng::soak;
  const std::optional<SoakOptions> options = read_options({arguments + 1, arguments + count});
  if (!options) {
    std::fprintf(
        stderr,
        "throng_soak: takes --minutes M, --rounds K or --seed N; and --first SEED, --times K, --headless, --tell\n");
    return 2;
  }
  return Soak(*options).run() ? EXIT_SUCCESS : EXIT_FAILURE;
}
