# SPDX-License-Identifier: GPL-3.0-or-later
# Results for other programs while the run lasts: docs/live-output.md, whose clients run here.
tests=$(cd "$(dirname "$0")" && pwd)
. "$tests/common.sh"

python3 "$tests/live_outputs.py" "$cli" "$tests/../../docs/live-output.md"
