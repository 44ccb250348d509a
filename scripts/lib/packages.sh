# Installs what scripts/packages lists, and what else is asked for, where the machine lacks it; silent and instant when
# nothing is missing.
# shellcheck shell=bash

missing_packages() {
  local package
  while read -r package; do
    [ -n "$package" ] || continue
    [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || echo "$package"
  done < <(grep '^[a-z]' scripts/packages && printf '%s\n' "$@")
}

# Reads what apt-get says: its status lines become a percentage (a line every tenth where there is no terminal), the rest
# goes to the log.
show_progress() {
  local log=$1 line kind percent text shown="" step=10
  [ ! -t 1 ] || step=1
  while read -r line; do
    case $line in
      dlstatus:* | pmstatus:*) IFS=: read -r kind _ percent text <<<"$line" ;;
      *)
        printf '%s\n' "$line" >>"$log"
        continue
        ;;
    esac
    percent=${percent%%.*}
    [ "$kind $((percent / step))" != "$shown" ] || continue
    shown="$kind $((percent / step))"
    if [ -t 1 ]; then printf '\r\033[K%3d%%  %s' "$percent" "$text"; else printf '%3d%%  %s\n' "$percent" "$text"; fi
  done
  [ ! -t 1 ] || printf '\r\033[K'
}

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; else sudo -- "$@"; fi
}

apt_get() {
  local log=build/packages.log
  as_root env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 \
    apt-get -q -y -o APT::Status-Fd=1 -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=120 "$@" </dev/null 2>&1 |
    show_progress "$log" || { tail -n 20 "$log" >&2 && fail "apt-get $1 failed; all that it said is in $log"; }
}

# install_packages [PACKAGE...]
install_packages() {
  command -v dpkg-query >/dev/null || fail "no dpkg here: install by hand what scripts/packages lists (names of Debian 12)"
  local missing
  mapfile -t missing < <(missing_packages "$@")
  [ ${#missing[@]} -gt 0 ] || return 0
  [ "$(id -u)" = 0 ] || command -v sudo >/dev/null ||
    fail "these packages are missing, and only root or sudo can install them: ${missing[*]}"
  say "Installing ${#missing[@]} packages: ${missing[*]}"
  mkdir -p build && : >build/packages.log
  apt_get update
  apt_get install --no-install-recommends "${missing[@]}"
}
