# Configures, builds and tests a preset of CMakePresets.json; ninja and ctest say how far they are.
# shellcheck shell=bash

configure() {
  local preset=$1 log=build/configure-$1.log
  if command -v ccache >/dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=ccache CMAKE_C_COMPILER_LAUNCHER=ccache; fi
  say "Configuring $preset"
  mkdir -p build
  cmake --preset "$preset" >"$log" 2>&1 || { cat "$log" >&2 && fail "configuring $preset failed"; }
}

# build PRESET [TARGET...]: without a target, everything.
build() {
  local preset=$1 folder=build/$1
  shift
  if [ ! -e "$folder/build.ninja" ] || [ CMakePresets.json -nt "$folder/build.ninja" ]; then configure "$preset"; fi
  say "Building $preset"
  ninja -C "$folder" "$@" || fail "building $preset failed"
}

# run_tests PRESET [OPTION OF CTEST...]
run_tests() {
  local preset=$1 fixed_addresses=()
  shift
  # The thread sanitizer of this compiler fails where the kernel spreads addresses wider than it knows.
  if [ "$preset" = tsan ] && setarch --addr-no-randomize true 2>/dev/null; then fixed_addresses=(setarch --addr-no-randomize); fi
  say "Testing $preset"
  LSAN_OPTIONS=suppressions=$PWD/scripts/lib/drivers-leaks.txt:print_suppressions=0 UBSAN_OPTIONS=print_stacktrace=1 "${fixed_addresses[@]}" \
    ctest --test-dir "build/$preset" --output-on-failure --no-tests=error --parallel "$(nproc)" "$@"
}
