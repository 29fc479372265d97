// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class Timeline;
struct Workbench;

/// Adds the timeline to the window, with the actions that go through time: markers, earlier frames,
/// tracking again from one. Sets the current frame of the selection.
Timeline* installTimeline(const Workbench& bench);

} // namespace dewpoint::ui
