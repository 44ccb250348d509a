# Sourced by the scripts: strict mode, the folder of the project, words for the person who waits.
# shellcheck shell=bash
set -euo pipefail

# shellcheck disable=SC2034  # read by scripts/demo
called_from=$PWD
project=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$project"

say() { printf '\n== %s\n' "$*"; }

fail() {
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 1
}
