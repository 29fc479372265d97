// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"

#include <QColor>

namespace dewpoint::ui {

/// Returns a light and clear color from the center of a range, which represents a learned color.
QColor rangeColor(const ColorRange& range);

} // namespace dewpoint::ui
