#!/usr/bin/env bash
# Run one check under a title and say how long it took: scripts/step.sh TITLE COMMAND...
set -euo pipefail
title=$1
shift
printf '\n== %s\n' "$title"
start=$(date +%s.%N)
status=0
"$@" || status=$?
printf '== %s: %s after %.1f s\n' "$title" \
    "$([[ $status -eq 0 ]] && echo passed || echo FAILED)" \
    "$(awk -v a="$start" -v b="$(date +%s.%N)" 'BEGIN { print b - a }')"
exit "$status"
