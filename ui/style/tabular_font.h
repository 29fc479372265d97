// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QFont>

namespace dewpoint::ui {

/// Returns a font for numbers that change: `font` if all its digits have the same width, so that
/// numbers do not jump; otherwise the fixed-width font of the system in the same size and weight.
QFont tabularFont(const QFont& font);

} // namespace dewpoint::ui
