# SPDX-License-Identifier: GPL-3.0-or-later
. "$(dirname "$0")/common.sh"

expectExit $kUsage experiment sugandi-rmse
expectExit $kBadInput experiment sugandi-rmse --out o --data .
expectSentence juggle1
