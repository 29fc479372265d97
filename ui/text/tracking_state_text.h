// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/tracking_state.h"

#include <QString>

namespace dewpoint::ui {

/// Returns a symbol and a word for a target state, for example "● tracking".
QString trackingStateText(TrackingState state);

} // namespace dewpoint::ui
