#!/bin/sh
# Makes `stack run` and `stack test` work on Debian 12 and 13, and on systems made from them, with the compiler
# and the libraries of the distribution. It may be run as often as you like: it installs only what is missing.
#
#   ./setup.sh           what building, running and testing Dioptre needs
#   ./setup.sh --gate    also what .ci/run needs: hlint, ormolu, doctest, shellcheck, python3, chromium
#   ./setup.sh --dev     also what a contributor wants: the above, and povray for the timings
#   ./setup.sh --help    this text
#
# Exit codes: 0 done, 1 something could not be installed, 2 wrong usage, 3 no apt here, 4 neither root nor sudo.
set -eu

# Everything that package.yaml names and that ghc does not bring along itself; .ci/run compares the two lists.
libraries='
  libghc-aeson-dev
  libghc-ansi-terminal-dev
  libghc-async-dev
  libghc-base64-bytestring-dev
  libghc-edit-distance-dev
  libghc-entropy-dev
  libghc-file-embed-dev
  libghc-fsnotify-dev
  libghc-hspec-dev
  libghc-http-types-dev
  libghc-juicypixels-dev
  libghc-linear-dev
  libghc-megaparsec-dev
  libghc-network-dev
  libghc-optparse-applicative-dev
  libghc-prettyprinter-ansi-terminal-dev
  libghc-prettyprinter-dev
  libghc-primitive-dev
  libghc-quickcheck2-dev
  libghc-temporary-dev
  libghc-terminal-progress-bar-dev
  libghc-vector-dev
  libghc-wai-dev
  libghc-wai-websockets-dev
  libghc-warp-dev
  libghc-websockets-dev
  libghc-zlib-dev
'
tools='ghc haskell-stack hspec-discover'
# A library that only the benchmarks name goes here, on a line of its own like those above.
gate_tools='
  chromium
  chromium-driver
  doctest
  git
  hlint
  ormolu
  python3
  python3-selenium
  shellcheck
'
dev_tools='povray'

say() { printf '%s\n' "setup.sh: $*"; }
fail() {
  code=$1
  shift
  for line in "$@"; do printf '%s\n' "setup.sh: $line" >&2; done
  exit "$code"
}
usage() { sed -n '2,/^set /s/^# \{0,1\}//p' "$0"; }

# missing PACKAGE...: those of them that are not installed, each after a blank.
missing() {
  installed=" $(dpkg-query -W -f '${db:Status-Status}=${Package} ' "$@" 2>/dev/null || true)"
  for package in "$@"; do
    case $installed in
      *" installed=$package "*) ;;
      *) printf ' %s' "$package" ;;
    esac
  done
}

# as_root COMMAND...: runs it as root, directly or through sudo.
as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

# install PACKAGE...
install() {
  if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
    fail 4 "these packages are missing and only root can install them (you are not root, and there is no sudo):" \
      "  $*" "Ask an administrator for: apt-get install --no-install-recommends $*"
  fi
  say "Installing with apt: $*"
  as_root apt-get -q update ||
    say "The package lists could not be brought up to date; trying with the ones that are here."
  # Never with recommended packages: they can bring ghc-doc, with which `stack haddock` fails.
  as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends install "$@" ||
    fail 1 "apt could not install everything (its own words are above). The usual reasons:" \
      "  no network: check it, then run ./setup.sh again;" \
      "  a release without one of these packages: Debian 12 and 13 have them all. On another system" \
      "  see stack-lts.yaml, which lets stack fetch compiler and libraries by itself."
}

packages="$tools $libraries"
case ${1-} in
  '') ;;
  --gate) packages="$packages $gate_tools" ;;
  --dev) packages="$packages $gate_tools $dev_tools" ;;
  -h | --help) usage && exit 0 ;;
  *) usage >&2 && exit 2 ;;
esac
[ $# -le 1 ] || { usage >&2 && exit 2; }

cd "$(dirname "$0")"

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  fail 3 "this system has no apt, so there is nothing that this script can install." \
    "With stack (https://docs.haskellstack.org), which then fetches compiler and libraries by itself:" \
    "  stack --stack-yaml stack-lts.yaml run" \
    "  stack --stack-yaml stack-lts.yaml test" \
    "With GHC 9.0 to 9.6, cabal and hpack:" \
    "  hpack && cabal run dioptre"
fi

# The lists are words without blanks in them: splitting them is what is wanted.
# shellcheck disable=SC2086
wanted=$(missing $packages)
if [ -n "$wanted" ]; then
  # shellcheck disable=SC2086
  install $wanted
else
  say "Everything that is needed is installed."
fi

# The distribution's libraries belong to the distribution's compiler, so that is the one stack has to use.
compiler=ghc-$(/usr/bin/ghc --numeric-version)
resolver=$(sed -n 's/^resolver: *//p' stack.yaml)
if [ "$resolver" = "$compiler" ]; then
  say "stack.yaml names the installed compiler, $compiler."
else
  # Into the same file rather than over it, so that its owner and permissions stay.
  changed=$(sed "s/^resolver:.*/resolver: $compiler/" stack.yaml)
  printf '%s\n' "$changed" >stack.yaml
  say "The installed compiler is $compiler: stack.yaml now says so (it said $resolver)."
fi
first=$(command -v ghc || true)
if [ "$first" != /usr/bin/ghc ] && [ "$first" != /bin/ghc ]; then
  say "Note that another ghc comes first in your PATH ($first). If stack does not find the libraries, run"
  say "  PATH=/usr/bin:\$PATH stack run"
fi
say "Ready. Next: stack run"
