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

# install_packages KIND...: installs what is missing of the packages of those kinds in packages.txt.
install_packages() {
  command -v dpkg-query >/dev/null || die "this is not a Debian system; scripts/packages.txt lists what is needed"
  local missing=() name kind
  while IFS='|' read -r name kind _; do
    name=${name//[[:space:]]/} kind=${kind//[[:space:]]/}
    case $name in '' | \#*) continue ;; esac
    case " $* " in *" $kind "*) ;; *) continue ;; esac
    # A package that another one provides (build tools, OpenGL) counts as present only under its own name.
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null)" = installed ] || missing+=("$name")
  done <scripts/packages.txt
  [ ${#missing[@]} -eq 0 ] && return
  say "installing ${missing[*]}"
  as_root apt-get update -qq
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
}

# build PRESET [TARGET...]
build() {
  local preset=$1
  shift
  local log
  log=$(mktemp)
  if ! cmake --preset "$preset" >"$log" 2>&1; then
    cat "$log" >&2
    rm -f "$log"
    die "configuring failed"
  fi
  rm -f "$log"
  say "building ($preset, $jobs jobs)"
  cmake --build --preset "$preset" --parallel "$jobs" ${1:+--target "$@"} >&2
}
