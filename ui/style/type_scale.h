// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QFont>

namespace dewpoint::ui {

// Font sizes in the window: the window font, and one step smaller.

/// Returns the font one step smaller, for secondary and explanatory texts.
inline QFont smallerFont(QFont font) {
  constexpr double kStep = 0.9;
  font.pointSizeF() > 0.0 ? font.setPointSizeF(kStep * font.pointSizeF())
                          : font.setPixelSize(static_cast<int>(kStep * font.pixelSize()));
  return font;
}

/// Returns a semi-bold font, for the name of an item in a list.
inline QFont mediumFont(QFont font) {
  font.setWeight(QFont::DemiBold);
  return font;
}

/// Returns the font for a section heading in a panel.
inline QFont headingFont(const QFont& font) {
  return mediumFont(smallerFont(font));
}

} // namespace dewpoint::ui
