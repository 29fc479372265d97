// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

class QGridLayout;

namespace dewpoint::ui {

/// Lets the Tab key visit the fields of a grid row by row, whatever order they were made in.
void orderTabsByRows(const QGridLayout& grid);

} // namespace dewpoint::ui
