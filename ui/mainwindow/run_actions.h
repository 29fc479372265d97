// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

struct Workbench;

/// Connects the actions that make the run go: play, single steps, from the beginning.
void installRunActions(const Workbench& bench);

} // namespace dewpoint::ui
