// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"

#include <QColor>

namespace dewpoint::ui {

/// Returns the brightened center color of a range, to represent a learned color.
QColor rangeColor(const ColorRange& range);

} // namespace dewpoint::ui
