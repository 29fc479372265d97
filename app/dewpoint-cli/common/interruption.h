// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::app {

/// Makes Ctrl-C and termination signals only request a stop from now on, instead of ending the
/// program.
void catchInterruption();
/// Returns whether Ctrl-C was pressed, or a termination signal received, since catchInterruption()
/// was called.
bool wasInterruptionRequested();

} // namespace dewpoint::app
