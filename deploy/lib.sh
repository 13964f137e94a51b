# shellcheck shell=bash
# What deploy/run, deploy/test and deploy/install share: find the repository, install, configure, build. It starts nothing
# itself and is read with `.`; the caller has set -euo pipefail.

# shellcheck disable=SC2034  # read by the callers
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
jobs=${DRIPFEED_JOBS:-$(nproc)}

say() { printf '== %s\n' "$*" >&2; }

# install SET: the Debian packages that are missing. SET is run, test or full.
install_packages() { "$root/deploy/install" "$1"; }

# configure PRESET [CMAKE ARGUMENTS...]: into build/PRESET.
configure() {
  local preset=$1
  shift
  say "configure $preset $*"
  (cd "$root" && cmake --preset "$preset" "$@" >/dev/null)
}

# build PRESET [TARGETS...]: everything when no target is named.
build() {
  local preset=$1
  shift
  say "build $preset $*"
  cmake --build "$root/build/$preset" -j "$jobs" ${1:+--target "$@"}
}

# run_tests PRESET [CTEST ARGUMENTS...]: ctest's own summary is the last thing printed. Its slots are half a core each (dripfeed_slots).
run_tests() {
  local preset=$1
  shift
  say "test $preset"
  ctest --test-dir "$root/build/$preset" -j "$((2 * jobs))" --output-on-failure --no-label-summary --no-tests=error "$@"
}

# The page and the documentation into web/dist. Nothing to do when no source is younger than the last build.
build_web() {
  local web=$root/web stamp=$root/web/dist/.built
  [[ -f $web/package.json ]] || return 0
  if [[ -f $stamp ]] && [[ -z $(find "$web" "$root/docs" "$root/README.md" -name node_modules -prune -o -path "$web/dist" -prune -o \
    -type f -newer "$stamp" -print -quit) ]]; then
    return 0
  fi
  say "build web"
  (cd "$web" && npm ci --no-audit --no-fund && npm run build)
  touch "$stamp"
}
