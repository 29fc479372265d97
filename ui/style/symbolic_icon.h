// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QIcon>
#include <QString>

class QPalette;

namespace dewpoint::ui {

/// Returns one of the window's single-stroke icons (resources/icons) in the text color of the
/// palette.
QIcon symbolicIcon(const QString& name, const QPalette& palette);

} // namespace dewpoint::ui
