#!/usr/bin/env bash
# Builds the manual as a site, build/docs/index.html: pages, search, the API reference; and the page of the sample in some of
# them, where tools/web.sh has built it. Exit 1 if a link is dead or a
# page lacks something, 3 if a tool cannot be had.
# usage: tools/docs.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
tools/install.sh tools/packages/docs.txt || exit 3
python=/usr/bin/python3  # Debian's, for which its mkdocs is made
[ -x "$python" ] || python=python3

"$python" tools/docs/pages.py build/docs-source
inputs=$("$python" tools/docs/api_comments.py --inputs build/docs-stages.dox)
{ cat tools/docs/Doxyfile; echo "INPUT = $inputs"; } | doxygen -
[ ! -s build/docs-api.log ] || { cat build/docs-api.log >&2; exit 1; }  # what is not documented
rm -rf build/docs
"$python" -m mkdocs build --quiet --strict --config-file tools/docs/mkdocs.yml
# The page of the sample, for pages that have it in a frame.
[ ! -f build/web/index.html ] || cp -r build/web build/docs/play
"$python" tools/docs/links.py build/docs
echo "build/docs/index.html; its search wants a server: python3 -m http.server -d build/docs"
