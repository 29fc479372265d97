// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QFont>

namespace dewpoint::ui {

/// Returns a font for changing numbers, in which all digits have the same width so that the numbers
/// do not jump. This is `font` if it has such digits, or else the system's fixed-width font with
/// the same size and weight.
QFont tabularFont(const QFont& font);

} // namespace dewpoint::ui
