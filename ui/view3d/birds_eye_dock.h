// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class BirdsEyeView;
struct Workbench;

/// Adds the bird's-eye view to the window. Methods that follow boxes in images have no positions
/// in the room: while one is chosen, the view is hidden.
BirdsEyeView* installBirdsEyeView(const Workbench& bench);

} // namespace dewpoint::ui
