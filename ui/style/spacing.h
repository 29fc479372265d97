// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

/// Spacing between neighboring controls and to the border of their container, in pixels. A design
/// choice; most desktops use 6 to 9.
inline constexpr int kSpacing = 8;

} // namespace dewpoint::ui
