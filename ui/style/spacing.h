// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

/// Between neighboring controls, and from them to the border of what they lie on: pixels; chosen,
/// as most desktops have 6 to 9.
inline constexpr int kSpacing = 8;

} // namespace dewpoint::ui
