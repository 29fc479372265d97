# SPDX-License-Identifier: GPL-3.0-or-later
# What the desktop reads: the entry in its menu, icons, the kind of file, the description.
. "$(dirname "$0")/common.sh"
share=$prefix/share
missing=''

# with TOOL COMMAND...: runs it, or remembers that the tool is not there.
with() {
  command -v "$1" >/dev/null || { missing+=" $1" && return; }
  "$@" >said.txt 2>&1 || fail "$*: $(cat said.txt)"
}

with desktop-file-validate "$share/applications/dewpoint.desktop"
with appstreamcli validate --no-net "$share/metainfo/org.dewpoint.dewpoint.metainfo.xml"
cp -r "$share/mime" mime
with update-mime-database mime
for size in 16 22 24 32 48 64 128 256; do
  for icon in apps/dewpoint mimetypes/application-x-dewpoint-project; do
    # Width and height stand in the header of a PNG.
    file=$share/icons/hicolor/${size}x$size/$icon.png
    [[ $(od -An -tu1 -j16 -N8 "$file" | awk '{ print $3 * 256 + $4, $7 * 256 + $8 }') == "$size $size" ]] || fail "$file has another size"
  done
done
for icon in apps/dewpoint mimetypes/application-x-dewpoint-project; do
  [[ -s $share/icons/hicolor/scalable/$icon.svg ]] || fail "$icon.svg is missing"
done

# The kind of a file, as the desktop finds it.
export XDG_DATA_HOME=$PWD XDG_DATA_DIRS=/usr/share
kindOf() { gio info -a standard::content-type "$1" | sed -n 's/.*content-type: //p'; }
if command -v gio >/dev/null && [[ -e mime/mime.cache ]]; then
  example=$DEWPOINT_SOURCES/docs/examples/barrera.toml
  cp "$example" ball.dewpoint
  cp "$example" ball
  echo 'format = "another program"' >other
  "$prefix/bin/dewpoint-cli" simulate still --out still --frames 1 --images >/dev/null
  cp still/project.toml saved
  for file in ball.dewpoint ball saved; do
    [[ $(kindOf $file) == application/x-dewpoint-project ]] || fail "$file is taken for $(kindOf $file)"
  done
  for file in other "$example"; do
    [[ $(kindOf "$file") != application/x-dewpoint-project ]] || fail "$file is taken for a project"
  done
else
  missing+=' gio'
fi
[[ -z $missing ]] || { echo "not tested, as these are not installed:$missing" && exit 77; }
