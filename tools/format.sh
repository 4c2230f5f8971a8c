#!/usr/bin/env bash
# Formats Marrow's C++ with clang-format; with --check only says what is not formatted and fails.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mode=(-i)
[ "${1:-}" = --check ] && mode=(--dry-run --Werror)
git ls-files -co --exclude-standard '*.cpp' '*.h' | xargs clang-format "${mode[@]}"
