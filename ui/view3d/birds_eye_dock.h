// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class BirdsEyeView;
struct Workbench;

/// Adds the bird's-eye view to the window. It is hidden while a method that tracks bounding boxes
/// is selected, because image boxes have no 3D positions.
BirdsEyeView* installBirdsEyeView(const Workbench& bench);

} // namespace dewpoint::ui
