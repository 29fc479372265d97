// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class Timeline;
struct Workbench;

/// Adds the timeline to the window, with the actions for markers, earlier frames and tracking again
/// from a frame. Also keeps the current frame of the selection up to date.
Timeline* installTimeline(const Workbench& bench);

} // namespace dewpoint::ui
