#!/usr/bin/env bash
# Tries the manual: its programs are those of tests, its commands run, its prose keeps to its limits, its figures
# agree, its links lead somewhere, and nothing public is undocumented. Exit 1 if something is wrong, 3 if a tool cannot
# be had.
# usage: tools/check/docs.sh MARROW      (the program)
set -euo pipefail
marrow=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
skipped=0
tools/install.sh tools/packages/docs.txt || skipped=3
try() {  # WHAT COMMAND ...
  local what=$1 code=0
  shift
  "$@" || code=$?
  [ $code -ne 3 ] || { echo "SKIPPED: $what" >&2; skipped=3; return 0; }
  [ $code -eq 0 ] || { echo "check/docs: $what" >&2; exit 1; }
}
try "programs that no test compiles" python3 tools/docs/snippets.py
try "figures" python3 tools/docs/figures.py
try "the picture of the sample" python3 tools/docs/picture.py
try "prose" python3 tools/docs/prose.py
try "the site" tools/docs.sh
try "commands" python3 tools/docs/commands.py "$marrow"
exit $skipped
