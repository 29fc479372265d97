// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

class QGridLayout;

namespace dewpoint::ui {

/// Makes the Tab key visit the fields of a grid row by row, regardless of the order in which they
/// were created.
void orderTabsByRows(const QGridLayout& grid);

} // namespace dewpoint::ui
