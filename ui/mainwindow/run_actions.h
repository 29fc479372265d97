// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

struct Workbench;

/// Connects the actions that control the run: play, single steps, restart.
void installRunActions(const Workbench& bench);

} // namespace dewpoint::ui
