// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QToolBar;

#include "core/base/floors.h"

namespace dewpoint::ui {

struct Workbench;

/// Adds the one toolbar, with what is done all the time.
QToolBar* installTransportBar(const Workbench& bench);

} // namespace dewpoint::ui
