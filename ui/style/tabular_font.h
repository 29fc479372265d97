// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QFont>

namespace dewpoint::ui {

/// A font for numbers that change: this one where its digits are all equally wide, so that nothing
/// jumps; else the system's font of fixed width in the same size and weight.
QFont tabularFont(const QFont& font);

} // namespace dewpoint::ui
