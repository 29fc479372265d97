// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::app {

/// Returns a page of the manual in Markdown: every action of the window with its default shortcut
/// and what it does. Shortcuts that the user changed are ignored.
QString actionReference();

} // namespace dewpoint::app
