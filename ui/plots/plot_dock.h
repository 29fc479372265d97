// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class PlotPanel;
struct Workbench;

/// Adds the dock with the plots of the run to the window.
PlotPanel* installPlots(const Workbench& bench);

} // namespace dewpoint::ui
