// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::app {

/// Makes Ctrl-C (and a termination request) only request a stop from now on.
void catchInterruption();
/// Whether a stop was requested since then.
bool interruptionRequested();

} // namespace dewpoint::app
