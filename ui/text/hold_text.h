// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/hold_state.h"

#include <QString>

namespace dewpoint::ui {

/// Returns a symbol and a word for a target state, for example "● tracking".
QString holdText(HoldState state);

} // namespace dewpoint::ui
