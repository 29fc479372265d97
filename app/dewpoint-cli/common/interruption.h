// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::app {

/// From now on Ctrl-C (and a request to end) only requests a stop.
void catchInterruption();
/// Whether it was pressed since.
bool interruptionRequested();

} // namespace dewpoint::app
