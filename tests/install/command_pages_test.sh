# SPDX-License-Identifier: GPL-3.0-or-later
# The manual pages and the completions have every command and option that --help has.
. "$(dirname "$0")/common.sh"

for program in $(programs); do
  zcat "$prefix/share/man/man1/$program.1.gz" >"$program.1"
  cp "$prefix/share/bash-completion/completions/$program" "$program.bash"
  cp "$prefix/share/zsh/vendor-completions/_$program" "_$program"
  cp "$prefix/share/fish/vendor_completions.d/$program.fish" .
  bash -n "$program.bash"
  ! command -v zsh >/dev/null || zsh -n "_$program"
  ! command -v fish >/dev/null || fish --no-execute "$program.fish"
  if command -v man >/dev/null; then
    man --warnings -E UTF-8 -l -Tutf8 "./$program.1" >page.txt 2>warnings.txt
    [[ ! -s warnings.txt ]] || fail "the page of $program: $(cat warnings.txt)"
  fi
done

for program in $(programs); do
  python3 "$here/declared_everywhere.py" "$prefix/bin/$program" "$program.1" "$program.bash" "_$program" "$program.fish"
done

# completeBash WORD...: what bash offers for the last word.
completeBash() {
  bash --norc -c '
    source "$1"
    COMP_WORDS=("${@:2}") COMP_CWORD=$(($# - 2))
    _dewpoint_cli
    printf "%s\n" "${COMPREPLY[@]}"' - dewpoint-cli.bash "$@"
}

# The beginning of a word, the choices of an option, and a name that two commands share.
[[ $(completeBash dewpoint-cli ev) == evaluate ]] || fail "bash does not complete 'ev'"
[[ $(completeBash dewpoint-cli track demo --method bar) == barrera ]] || fail "bash does not complete a method"
[[ $(completeBash dewpoint-cli export --gaps = fi) == fill ]] || fail "bash does not complete behind a ="
[[ -z $(completeBash dewpoint-cli track --out '') ]] || fail "bash does not leave a folder to the shell"
completeBash dewpoint-cli experiment wand -- | grep -qx -- --jpeg || fail "bash takes one command for another"
if command -v fish >/dev/null; then
  completeFish() { HOME=$PWD XDG_CONFIG_HOME=$PWD fish --no-config -c "source dewpoint-cli.fish; complete -C '$1'" | cut -f 1; }
  [[ $(completeFish 'dewpoint-cli ev') == evaluate ]] || fail "fish does not complete 'ev'"
  [[ $(completeFish 'dewpoint-cli track demo --method bar') == barrera ]] || fail "fish does not complete a method"
  completeFish 'dewpoint-cli calibration ' | grep -qx convert || fail "fish does not complete below a command"
fi
