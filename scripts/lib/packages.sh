# Installs what scripts/packages lists, and what else is asked for, where the machine lacks it; silent and instant when
# nothing is missing. Where there is no apt-get it says what to install by hand.
# shellcheck shell=bash

# package_names COLUMN: that column of scripts/packages.
package_names() { awk -v column="$1" '!/^#/ && NF && $column != "-" { print $column }' scripts/packages; }

# missing_ones keeps, of the names that it reads, the packages that are not installed; known_ones keeps the packages that
# the lists of this system have.
missing_ones() {
  local package
  while read -r package; do
    [ -n "$package" ] || continue
    [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || echo "$package"
  done
}

known_ones() {
  local package
  while read -r package; do
    if [ -n "$package" ] && apt-cache show "$package" >/dev/null 2>&1; then echo "$package"; fi
  done
}

# Says what to install by hand, in the names of this system, and ends.
refuse_other_system() {
  local ids install
  ids=" $(. /etc/os-release 2>/dev/null && echo "${ID:-} ${ID_LIKE:-}") "
  case $ids in
    *" fedora "*) install="dnf install $(package_names 2 | xargs)" ;;
    *" arch "*) install="pacman -S --needed $(package_names 3 | grep -v '\*$' | xargs), and $(package_names 3 | sed -n 's/\*$//p' | xargs) of its user repository" ;;
    *) install="install what scripts/packages lists" ;;
  esac
  fail "no apt-get here: $install; then cmake --preset release and ninja -C build/release throng"
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
  command -v apt-get >/dev/null || refuse_other_system
  local optional
  local -a needed known
  mapfile -t needed < <({ package_names 1 && printf '%s\n' "$@"; } | grep -v '?$' | missing_ones)
  optional=$(package_names 1 | sed -n 's/?$//p' | missing_ones)
  mapfile -t known < <(known_ones <<<"$optional")
  [ $((${#needed[@]} + ${#known[@]})) -gt 0 ] || return 0
  [ "$(id -u)" = 0 ] || command -v sudo >/dev/null ||
    fail "these packages are missing, and only root or sudo can install them: ${needed[*]} ${known[*]}"
  mkdir -p build && : >build/packages.log
  say "Fetching the lists of packages"
  apt_get update
  mapfile -t known < <(known_ones <<<"$optional")  # by the lists of today
  say "Installing $((${#needed[@]} + ${#known[@]})) packages: ${needed[*]} ${known[*]}"
  apt_get install --no-install-recommends "${needed[@]}" "${known[@]}"
}
