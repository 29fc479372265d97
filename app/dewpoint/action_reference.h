// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::app {

/// Every action of the window with its shortcut and what it does, as a page of the manual in
/// Markdown. Shortcuts are those that actions are declared with, not those that the user chose.
QString actionReference();

} // namespace dewpoint::app
