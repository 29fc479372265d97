// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QFont>

namespace dewpoint::ui {

/// Returns a font in which all digits have the same width, so that changing numbers do not jump.
/// This is `font` if it has such digits; otherwise, the system's fixed-width font with the same
/// size and weight.
QFont tabularFont(const QFont& font);

} // namespace dewpoint::ui
