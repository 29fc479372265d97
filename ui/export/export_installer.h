// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class Timeline;
struct Workbench;

/// Adds the export of the run: its trajectory, or its bounding boxes if the method tracks boxes.
/// `timeline` provides the times of the selected range.
void installExport(const Workbench& bench, const Timeline& timeline);

} // namespace dewpoint::ui
