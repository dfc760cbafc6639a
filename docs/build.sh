#!/bin/sh
# Builds the site of the course: sh docs/build.sh [OUTDIR]   (default build/site/html)
# Needs doxygen, python3, node and npm. Any warning, broken link or missing
# picture fails the build, and the site that was there before stays.
set -eu
cd "$(dirname "$0")/.."
out=${1:-build/site/html}
mkdir -p "$(dirname "$out")"
out=$(cd "$(dirname "$out")" && pwd)/$(basename "$out")
WORK=$out.work
PYTHON=$(python3 -c 'import sys; print(sys.executable)')  # a wrapper would start slowly
export WORK PYTHON PYTHONDONTWRITEBYTECODE=1
rm -rf "$WORK"
mkdir -p "$WORK/doxygen"

if ! cmp -s docs/package-lock.json docs/node_modules/.installed; then
  npm ci --prefix docs
  cp docs/package-lock.json docs/node_modules/.installed
fi

"$PYTHON" docs/tools/prepare.py "$WORK"
if ! doxygen docs/Doxyfile || [ -s "$WORK/doxygen.log" ]; then
  echo "site: Doxygen warns:" >&2
  cat "$WORK/doxygen.log" >&2
  exit 1
fi
"$PYTHON" docs/tools/describe.py "$WORK"
node docs/tools/typeset.mjs "$WORK/fragments.json" "$WORK/typeset.json"
"$PYTHON" docs/tools/finish.py "$WORK" "$WORK/html"
"$PYTHON" docs/check_site.py "$WORK/html"

rm -rf "$out"
mv "$WORK/html" "$out"
rm -rf "$WORK"
echo "site: $out/index.html"
