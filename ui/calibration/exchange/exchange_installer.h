// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

struct Workbench;

/// Adds the dialogs that take calibrations from other tools and give them to those.
void installCalibrationExchange(const Workbench& bench);

} // namespace dewpoint::ui
