#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Brings the catalogs in a folder up to date with the texts in the sources: new texts are added as
# unfinished, texts that are gone are dropped. Run through script/translate.
# Usage: update.sh LUPDATE DEWPOINT-STRINGS SOURCE-FOLDER CATALOG-FOLDER
set -euo pipefail
lupdate=$1 strings=$2 sources=$3 catalogs=$4

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$strings" >"$scratch/core.cpp"
others=()
for catalog in "$catalogs"/dewpoint_*.ts; do
  [[ $catalog == */dewpoint_en.ts ]] || others+=("$catalog")
done
cd "$sources"
common=(-silent -I . -no-obsolete -locations none -source-language en ui app/dewpoint "$scratch/core.cpp")
"$lupdate" "${common[@]}" -ts "${others[@]}"
# English needs only what differs by number: "1 sample", "2 samples".
"$lupdate" -pluralonly "${common[@]}" -ts "$catalogs/dewpoint_en.ts"
