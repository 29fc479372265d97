// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

struct Workbench;

/// Adds the toolbar with the most frequent actions.
void installTransportBar(const Workbench& bench);

} // namespace dewpoint::ui
