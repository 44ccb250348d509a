# Builds throng::anim and throng::pack as a project of someone else does (tests/ports): with another compiler, another
# standard library, for another processor or system; and holds its poses to the pinned hashes.
# shellcheck shell=bash

# build_port NAME [OPTION OF CMAKE...]: all of it, or what $port_target names.
build_port() {
  local name=$1 folder=build/port-$1 log=build/configure-port-$1.log
  shift
  if command -v ccache >/dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=ccache CMAKE_C_COMPILER_LAUNCHER=ccache; fi
  say "Building for $name"
  mkdir -p build
  cmake -S tests/ports -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release "$@" >"$log" 2>&1 ||
    { cat "$log" >&2 && fail "configuring for $name failed"; }
  ninja -C "$folder" ${port_target:+"$port_target"} || fail "building for $name failed"
}

# test_port NAME [OPTION OF CMAKE...]
test_port() {
  build_port "$@"
  ctest --test-dir "build/port-$1" --output-on-failure --no-tests=error || fail "the tests for $1 failed"
}

# Leaves a port out, and says so, if one of its commands is missing: can_port NAME PACKAGES COMMAND...
can_port() {
  local name=$1 packages=$2 command
  shift 2
  for command in "$@"; do
    if ! command -v "$command" >/dev/null; then
      say "Leaving out $name: there is no $command (apt-get install $packages)"
      return 1
    fi
  done
}

# The source of Highway as Debian has it, for compilers that no package of it is for. Needs no root.
highway_source() {
  local folder=$PWD/build/highway
  if ! compgen -G "$folder/highway-*/" >/dev/null; then
    mkdir -p "$folder/lists/partial" "$folder/cache/archives/partial"
    (
      cd "$folder"
      . /etc/os-release
      site=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' | head -1)  # where the machine's packages come from
      echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $site $VERSION_CODENAME main" >sources.list
      options=(-o "Dir::Etc::sourcelist=$folder/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$folder/lists"
        -o "Dir::Cache=$folder/cache")
      apt-get "${options[@]}" update && apt-get "${options[@]}" source --download-only highway && tar xf highway_*.orig.tar.gz
    ) >"$folder/log" 2>&1 || { cat "$folder/log" >&2 && fail "Highway's source cannot be fetched"; }
  fi
  compgen -G "$folder/highway-*/"
}

# Headers of others that are the same for every system, without those of this one beside them.
plain_headers() {
  local folder=$PWD/build/headers
  mkdir -p "$folder"
  (cd /usr/include && cp -r glm xxhash.h CLI EGL GLFW KHR draco expat.h expat_external.h imgui libpng16/* meshoptimizer.h nlohmann \
    sqlite3.h stb tiny_gltf.h webp zconf.h zlib.h "$folder")
  echo "$folder"
}

# arm64, wherever its compiler and an emulator are: on_arm64 test_port, or build_port.
on_arm64() {
  can_port arm64 "g++-aarch64-linux-gnu qemu-user" aarch64-linux-gnu-g++ qemu-aarch64 || return 0
  local highway
  highway=$(highway_source)
  "$1" arm64 -DCMAKE_TOOLCHAIN_FILE="$PWD/scripts/lib/toolchains/aarch64-linux-gnu.cmake" -DPORT_HIGHWAY="$highway"
}

# Windows, wherever its compiler is: the library and all sources of the program are compiled. Tests run where Wine is.
on_windows() {
  can_port windows g++-mingw-w64-x86-64-posix x86_64-w64-mingw32-g++-posix || return 0
  local highway headers act=build_port
  highway=$(highway_source) headers=$(plain_headers)
  if can_port "the tests on windows" wine64 /usr/lib/wine/wine64; then act=test_port; fi
  "$act" windows -DCMAKE_TOOLCHAIN_FILE="$PWD/scripts/lib/toolchains/x86_64-w64-mingw32.cmake" \
    -DPORT_PROGRAM=ON -DPORT_HIGHWAY="$highway" -DPORT_HEADERS="$headers"
}

# WebAssembly with threads and vectors of 128 bits, whose tests run under Node.js. Debian 13 has the Emscripten that it needs.
on_wasm() {
  can_port WebAssembly "emscripten nodejs" emcc em-config node || return 0
  if [ "$(printf '%s\n' 3.1.69 "$(emcc -dumpversion)" | sort -V | head -n 1)" != 3.1.69 ]; then
    say "Leaving out WebAssembly: Emscripten is older than 3.1.69"
    return 0
  fi
  local highway headers
  highway=$(highway_source) headers=$(plain_headers)
  test_port wasm -DCMAKE_TOOLCHAIN_FILE="$PWD/scripts/lib/toolchains/wasm32-emscripten.cmake" -DPORT_HIGHWAY="$highway" \
    -DPORT_HEADERS="$headers"
}

test_clang() { test_port clang -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++; }

test_all_ports() {
  test_clang
  test_port shared -DBUILD_SHARED_LIBS=ON
  test_port plain "-DCMAKE_CXX_FLAGS=-fno-exceptions -fno-rtti"
  if can_port libc++ "clang-16 libc++-16-dev libc++abi-16-dev" clang++-16 && [ -e /usr/lib/llvm-16/include/c++/v1 ]; then
    test_port libc++ -DCMAKE_C_COMPILER=clang-16 -DCMAKE_CXX_COMPILER=clang++-16 -DCMAKE_CXX_FLAGS=-stdlib=libc++
  fi
  on_arm64 test_port
  on_windows
  on_wasm
}
