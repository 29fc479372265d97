// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class Timeline;
struct Workbench;

/// Adds the timeline to the window, with the actions that go through time: marks, earlier moments,
/// tracking again from one. What the selection calls the moment comes from here.
Timeline* installTimeline(const Workbench& bench);

} // namespace dewpoint::ui
