#include "tests/soak/soak.h"

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <mutex>

#include "engine/anim/base/misuse.h"

namespace throng::soak {
namespace {

namespace fs = std::filesystem;

bool tells = false;
std::mutex misuse_mutex;
std::string misuse;  // the first that the library told of

void hear(const Misuse& heard) {
  const std::lock_guard lock(misuse_mutex);
  if (misuse.empty()) misuse = std::string("a misuse in this process: ") + heard.call + ": " + heard.reason;
}

Fault misuse_heard() {
  const std::lock_guard lock(misuse_mutex);
  return misuse.empty() ? Fault{} : misuse;
}

template <typename Number>
bool read(const std::string& text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

/// Neither a display of this machine nor what a person keeps is touched.
void set_environment(const fs::path& folder) {
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  setenv("XDG_CONFIG_HOME", (folder / "config").c_str(), 1);
}

}  // namespace

void tell(const std::string& line) {
  if (tells) std::printf("  %s\n", line.c_str());
  std::fflush(stdout);
}

std::string table_of(const std::string& who, const Counts& counts) {
  std::string text;
  for (const auto& [what, count] : counts) text += who + ", " + what + ": " + std::to_string(count) + "\n";
  return text;
}

std::optional<SoakOptions> read_options(const std::vector<std::string>& words) {
  SoakOptions options;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "--headless") options.headless = true;
    if (word == "--tell") options.tell = true;
    if (word == "--headless" || word == "--tell") continue;
    if (++i == words.size()) return {};
    const std::string& value = words[i];
    const bool read_it =
        (word == "--minutes" && read(value, options.minutes)) || (word == "--rounds" && read(value, options.rounds)) ||
        (word == "--first" && read(value, options.first)) ||
        (word == "--seed" && read(value, options.again.emplace())) || (word == "--times" && read(value, options.times));
    if (!read_it) return {};
  }
  if (options.minutes <= 0 && options.rounds <= 0 && !options.again) return {};
  return options;
}

Soak::Soak(const SoakOptions& options) : options_(options), models_(find_models()) {
  tells = options.tell || options.again;
  set_environment(folder_.path());
  set_misuse_hook(hear);
}

std::uint64_t Soak::seed_of(int round) const {
  return options_.again.value_or(options_.first + static_cast<std::uint64_t>(round));
}

bool Soak::is_over(int round) const {
  if (options_.again) return round >= options_.times;
  if (options_.minutes <= 0) return round >= options_.rounds;
  return std::chrono::duration<double>(Clock::now() - begin_).count() > 60 * options_.minutes;
}

bool Soak::is_warm(int round) const {
  if (options_.again) return round >= 2;
  if (options_.minutes <= 0) return round >= options_.rounds / 2;
  return std::chrono::duration<double>(Clock::now() - begin_).count() > 60 * options_.minutes * 0.2;
}

// A driver lets go of what it keeps for a context once the context is closed; what nobody owns is still there then.
Fault Soak::measure(const ShowRounds& shows) {
  const ShowRounds::Others others{.open_files = windows_ ? windows_->open_files() : 0, .draw = !options_.again};
  shows.measure(growth_, others);
  if (!growth_.is_above()) return {};
  Fault fault = shows_.renew();
  if (!fault) fault = drawn_shows_.renew();
  if (!fault) shows.measure(growth_, others);
  return fault;
}

Fault Soak::run_round(const RoundPlace& place) {
  const std::uint64_t kind = place.seed % 8;
  if (kind < 3) return programs_.run(place);
  if (kind == 7 && !options_.headless) {
    if (!windows_) windows_.emplace(models_, folder_.path() / "window");
    Fault fault = windows_->run(place);
    if (!fault) windows_->measure(growth_);
    return fault;
  }
  ShowRounds& shows = kind < 6 ? shows_ : drawn_shows_;
  Fault fault = options_.again ? Fault{} : shows_.open();
  if (!fault && !options_.again) fault = drawn_shows_.open();
  if (!fault) fault = shows.run(place);
  return fault ? fault : measure(shows);
}

Fault Soak::run_round(std::uint64_t seed) {
  const RoundPlace place{seed, folder_.path() / "round"};
  fs::create_directories(place.folder);
  Fault fault = run_round(place);
  if (!fault) fs::remove_all(place.folder);
  return fault;
}

bool Soak::run() {
  if (const auto missing = option_left_out()) return std::fprintf(stderr, "throng_soak: %s\n", missing->c_str()), false;
  int round = 0;
  Fault fault;
  for (; !fault && !is_over(round); ++round) {
    if (is_warm(round)) growth_.end_warm_up();
    const std::uint64_t seed = seed_of(round);
    std::printf("scripts/soak --seed %llu\n", static_cast<unsigned long long>(seed));
    std::fflush(stdout);
    fault = run_round(seed);
    if (!fault) fault = misuse_heard();
    if (!fault) fault = growth_.grown();
  }
  if (windows_ && !fault) fault = windows_->close();
  print_table(round);
  if (fault)
    std::fprintf(stderr, "throng_soak: round %llu: %s\n", static_cast<unsigned long long>(seed_of(round - 1)),
                 fault->c_str());
  return !fault;
}

void Soak::print_table(int rounds) const {
  const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
  std::printf("\n%d rounds in %.0f s\n", rounds, seconds);
  for (const std::string& part : {programs_.table(), shows_.table(), drawn_shows_.table(),
                                  windows_ ? windows_->table() : std::string(), growth_.table()}) {
    std::printf("%s", part.c_str());
  }
}

}  // namespace throng::soak
