// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"

#include <QColor>

namespace dewpoint::ui {

/// A light and clear color from the middle of a range: what the user sees of a learned color.
QColor rangeColor(const ColorRange& range);

} // namespace dewpoint::ui
