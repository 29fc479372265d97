// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class Timeline;
struct Workbench;

/// Adds the export of the run: of its trajectory, or of its boxes when the method follows those.
/// The timeline knows the times of the selected range.
void installExport(const Workbench& bench, const Timeline& timeline);

} // namespace dewpoint::ui
