# Runs both commands in bare systems: nothing but Debian's base, and a copy of what is committed. Needs root and
# debootstrap. A base is made once and kept in build/systems.
# shellcheck shell=bash

system_suites=(bookworm trixie sid)

# make_base SUITE: build/systems/SUITE, from where this machine's packages come, and as apt fetches them here.
make_base() {
  local suite=$1 base=$PWD/build/systems/$1 site
  [ ! -e "$base.made" ] || return 0
  site=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' | head -n 1)
  rm -rf "$base"
  say "Making a bare $suite"
  debootstrap --variant=minbase "$suite" "$base" "$site" >"$base.log" 2>&1 || fail "debootstrap $suite failed; all that it said is in $base.log"
  echo "deb $site $suite main" >"$base/etc/apt/sources.list"
  apt-config dump --no-empty --format '%F "%v";%n' Acquire >"$base/etc/apt/apt.conf.d/00fetching"
  touch "$base.made"
}

# in_system ROOT COMMAND...
in_system() {
  local root=$1
  shift
  env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb CI="${CI:-}" \
    chroot "$root" /bin/bash -c 'cd /throng && exec "$@"' bare "$@"
}

# The versions that a picture and a build depend on.
versions_of() {
  in_system "$1" dpkg-query --show --showformat '${Package} ${Version}\n' g++ cmake libhwy-dev libimgui-dev libgl1-mesa-dri |
    sed -E 's/ ([0-9]+:)?([^-+~]*).*/ \2/; s/libgl1-mesa-dri/Mesa/; s/libhwy-dev/Highway/; s/libimgui-dev/ImGui/; s/^cmake/CMake/' |
    xargs | sed 's/ \([A-Zg]\)/, \1/g'
}

# test_system SUITE: a row for tests/systems.md.
test_system() (
  suite=$1 base=$PWD/build/systems/$1 root=$PWD/build/systems/$1.run log=$PWD/build/systems/$1.log
  make_base "$suite"
  rm -rf "$root"
  cp -a --reflink=auto "$base" "$root"
  mkdir "$root/throng"
  git archive HEAD | tar -x -C "$root/throng"
  cp -L /etc/resolv.conf /etc/hosts "$root/etc/"
  trap 'umount "$root/dev/shm" "$root/dev" "$root/proc"; rm -rf --one-file-system "$root"' EXIT
  mount -t proc proc "$root/proc"
  mount --bind /dev "$root/dev"
  mount -t tmpfs tmpfs "$root/dev/shm"
  row="| $(date +%F) | $(git rev-parse --short HEAD) | $suite"
  for command in demo test; do
    say "scripts/$command in a bare $suite; what it says is in $log"
    SECONDS=0
    if in_system "$root" "scripts/$command" >"$log" 2>&1; then result=passed; else result="failed ($?)"; fi
    row+=" | $result, $(((SECONDS + 30) / 60)) min"
    [ "$result" = passed ] || break
  done
  echo "$row | $(versions_of "$root") |"
  [ "$result" = passed ] || { tail -n 30 "$log" >&2 && fail "scripts/$command failed in a bare $suite"; }
)

test_systems() {
  local suite
  [ "$(id -u)" = 0 ] || fail "--systems needs root, for chroot"
  install_packages debootstrap
  mkdir -p build/systems
  for suite in "${@:-${system_suites[@]}}"; do test_system "$suite"; done
}
