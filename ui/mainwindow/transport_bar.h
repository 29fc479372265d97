// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

struct Workbench;

/// Adds the one toolbar, with what is done all the time.
void installTransportBar(const Workbench& bench);

} // namespace dewpoint::ui
