// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class Timeline;
struct Workbench;

/// Adds the export of the run as a video. `timeline` provides the times of the frames and of the
/// selected range.
void installVideoExport(const Workbench& bench, const Timeline& timeline);

} // namespace dewpoint::ui
