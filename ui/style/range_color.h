// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"

#include <QColor>

namespace dewpoint::ui {

/// Returns a color that represents a learned color range: its center, brightened.
QColor rangeColor(const ColorRange& range);

} // namespace dewpoint::ui
