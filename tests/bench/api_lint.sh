#!/bin/bash
# Holds the description of the API against Spectral's rules for OpenAPI and the newest Redocly's, warnings as faults. By hand: both come from the
# registry of npm, and Spectral with its packages is 68 MB. ctest has the rules of Redocly that are installed already (web_api_lint).
#   api_lint.sh [DRIPFEED]
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${1:-$root/build/dev/dripfeed}" openapi >"$folder/openapi.json"
printf 'extends: ["spectral:oas"]\n' >"$folder/spectral.yaml"
cd "$folder"
npx --yes --package @stoplight/spectral-cli@6.16.3 spectral lint openapi.json --ruleset spectral.yaml --fail-severity hint
npx --yes @redocly/cli@2.77.0 lint openapi.json --extends recommended --max-problems 1000 | tee redocly.txt
! grep -q warning redocly.txt
