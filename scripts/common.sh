# Shared by the scripts in this folder; sourced, not run.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
jobs=$(nproc)

say() { printf '==> %s\n' "$*" >&2; }

die() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    die "this needs root and there is no sudo: $*"
  fi
}

# packages KIND...: the names of the packages of those kinds in packages.txt.
packages() {
  local name kinds kind
  while IFS='|' read -r name kinds _; do
    name=${name//[[:space:]]/}
    case $name in '' | \#*) continue ;; esac
    for kind in $kinds; do
      case " $* " in *" $kind "*) printf '%s\n' "$name" ;; esac
    done
  done <scripts/packages.txt
}

# install_packages KIND...: installs what is missing of the packages of those kinds.
install_packages() {
  command -v dpkg-query >/dev/null || die "this is not a Debian system; scripts/packages.txt lists what is needed"
  local missing start=$SECONDS
  # A package that another one provides (build tools, OpenGL) counts as present only under its own name.
  mapfile -t missing < <(comm -23 <(packages "$@" | sort -u) \
    <(dpkg-query -W -f='${Package} ${db:Status-Status}\n' | sed -n 's/ installed$//p' | sort -u))
  [ ${#missing[@]} -eq 0 ] && return
  say "installing ${missing[*]}"
  as_root apt-get update -qq
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
  say "packages installed in $((SECONDS - start)) s"
}

# is_configured PRESET: whether its build folder is there, newer than the presets, and has the preset's option turned on.
# Ninja itself configures again when a CMake file changes.
is_configured() {
  local folder=build/$1 option=
  case $1 in
    test) folder=build/release option=DRAPE_BUILD_TESTS ;;
    bench) folder=build/release option=DRAPE_BUILD_BENCHMARKS ;;
  esac
  [ "$folder/build.ninja" -nt CMakePresets.json ] || return
  [ -z "$option" ] || grep -q "^$option:.*=ON$" "$folder/CMakeCache.txt"
}

# configure PRESET
configure() {
  is_configured "$1" && return
  local log start=$SECONDS
  log=$(mktemp)
  if ! cmake --preset "$1" >"$log" 2>&1; then
    cat "$log" >&2
    rm -f "$log"
    die "configuring failed"
  fi
  rm -f "$log"
  say "configured ($1) in $((SECONDS - start)) s"
}

# build PRESET [TARGET...]
build() {
  local preset=$1 start
  shift
  configure "$preset"
  start=$SECONDS
  say "building ($preset, $jobs jobs)"
  cmake --build --preset "$preset" --parallel "$jobs" ${1:+--target "$@"} >&2
  say "built ($preset) in $((SECONDS - start)) s"
}

# names_of KIND: the names of all scenes, solvers, ... that `drape-headless list KIND` prints, by the program "$program".
names_of() {
  "$program" list "$1" --json | sed -n 's/^ *"name": "\([^"]*\)".*/\1/p'
}
