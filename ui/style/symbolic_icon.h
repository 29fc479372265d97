// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QIcon>
#include <QString>

class QPalette;

namespace dewpoint::ui {

/// One of the window's own one-stroke icons (resources/icons), drawn in the palette's text color.
QIcon symbolicIcon(const QString& name, const QPalette& palette);

} // namespace dewpoint::ui
