#!/usr/bin/env bash
# Installs the Debian packages named in the given lists that are missing; does nothing when all are there.
# usage: tools/install.sh LIST...
set -euo pipefail

missing=()
for package in $(sed 's/#.*//' "$@"); do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

if ! command -v apt-get >/dev/null; then
  echo "install: please install these packages' equivalents: ${missing[*]}" >&2
  exit 2
fi
as_root=()
if [ "$(id -u)" -ne 0 ]; then as_root=(sudo -n); fi
echo "install: ${missing[*]}" >&2
export DEBIAN_FRONTEND=noninteractive
install() { "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null; }
# The package lists may be absent or stale: refresh them only then.
install 2>/dev/null || { "${as_root[@]}" apt-get update -qq >/dev/null && install; }
