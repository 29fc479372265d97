# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by every test here: "$cli" is the program, the current folder is empty and private.
set -euo pipefail
cli=$1
rm -rf "$2"
mkdir -p "$2"
cd "$2"

readonly kUsage=2 kBadInput=3 kEndedEarly=4 kOutput=5

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# expectExit CODE ARGUMENTS...: runs the program, checks how it ends; output is in out.txt, err.txt.
expectExit() {
  local expected=$1 actual=0
  shift
  "$cli" "$@" >out.txt 2>err.txt </dev/null || actual=$?
  [[ $actual == "$expected" ]] ||
    fail "'dewpoint-cli $*' ended with $actual, not $expected; it said: $(cat err.txt)"
}

# expectSentence WORD...: the error was one line and holds each word. FFmpeg may say something of its
# own about a broken file, as "[format @ address] ...".
expectSentence() {
  [[ $(grep -v '^\[[a-z0-9,]* @ 0x' err.txt | grep -c .) == 1 ]] || fail "not one sentence: $(cat err.txt)"
  ! grep -qE "\b([[:alpha:]]{3,})[ ':(]+\1\b" err.txt || fail "a word twice: $(cat err.txt)"
  local word
  for word in "$@"; do
    grep -qF -- "$word" err.txt || fail "'$word' is missing in: $(cat err.txt)"
  done
}

# expectText FILE WORD...
expectText() {
  local file=$1 word
  shift
  for word in "$@"; do
    grep -qF -- "$word" "$file" || fail "'$word' is missing in $file: $(head -c 2000 "$file")"
  done
}

# rowCount FILE: rows of a CSV file, without comments and the line of column names.
rowCount() { grep -vc -e '^#' -e '^time_s' -e '^frame' "$1" || true; }
