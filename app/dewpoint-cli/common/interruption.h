// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::app {

/// Changes the effect of Ctrl-C and of a termination request: from now on, they only request a
/// stop.
void catchInterruption();
/// Returns whether a stop was requested since catchInterruption() was called.
bool interruptionRequested();

} // namespace dewpoint::app
