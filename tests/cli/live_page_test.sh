# SPDX-License-Identifier: GPL-3.0-or-later
# The page beside the WebSocket in a browser, which is wanted but not needed for the other tests.
tests=$(cd "$(dirname "$0")" && pwd)
. "$tests/common.sh"

if ! chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome); then
  echo 'SKIPPED: chromium is not installed (script/setup)'
  exit 77
fi
python3 "$tests/live_page.py" "$cli" "$chromium"
