# SPDX-License-Identifier: GPL-3.0-or-later
# Everything is where it belongs, and nothing refers to the folder of the sources.
. "$(dirname "$0")/common.sh"

for program in $(programs); do
  for file in bin/$program share/man/man1/$program.1.gz share/bash-completion/completions/$program \
    share/zsh/vendor-completions/_$program share/fish/vendor_completions.d/$program.fish; do
    [[ -s $prefix/$file ]] || fail "$file is not installed"
  done
  "$prefix/bin/$program" --version | grep -qE '[0-9]+\.[0-9]+\.[0-9]+' || fail "$program has no version"
done
# The window looks for its manual at ../share/dewpoint/docs, beside the program.
for page in "$DEWPOINT_SOURCES"/docs/*.md "$DEWPOINT_SOURCES"/docs/images/*; do
  cmp -s "$page" "$prefix/share/dewpoint/docs/${page#"$DEWPOINT_SOURCES"/docs/}" || fail "$page is not in the manual"
done

for pattern in Qt5 Qt6 vtk; do
  ! ldd "$prefix/bin/dewpoint-cli" | grep -i "$pattern" || fail "dewpoint-cli loads $pattern"
done
if [[ -x $prefix/bin/dewpoint ]]; then
  ! ldd "$prefix/bin/dewpoint" | grep -i qt5 || fail "the window loads Qt 5"
fi
for program in $(programs); do
  ! readelf -d "$prefix/bin/$program" | grep -E 'R(UN)?PATH' || fail "$program looks for libraries in a folder"
done

# Others can compile against this folder wherever the sources went.
stale=$(grep -rlF -- "$DEWPOINT_SOURCES" "$prefix"/lib*/cmake "$prefix"/lib*/*/cmake "$prefix/include" "$prefix/share" 2>/dev/null || true)
[[ -z $stale ]] || fail "the folder of the sources is named in: $stale"
