// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QFont>

namespace dewpoint::ui {

// The sizes in which the window writes: its own font, and one step below it.

/// One step smaller: for what stands beside something or explains it.
inline QFont smallerFont(QFont font) {
  constexpr double kStep = 0.9;
  font.pointSizeF() > 0.0 ? font.setPointSizeF(kStep * font.pointSizeF())
                          : font.setPixelSize(static_cast<int>(kStep * font.pixelSize()));
  return font;
}

/// For the name of one thing among several.
inline QFont mediumFont(QFont font) {
  font.setWeight(QFont::DemiBold);
  return font;
}

/// For the heading of a section within a panel.
inline QFont headingFont(const QFont& font) {
  return mediumFont(smallerFont(font));
}

} // namespace dewpoint::ui
