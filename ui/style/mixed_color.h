// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QColor>

namespace dewpoint::ui {

/// Returns a mixture of two colors: `share` 0 gives `one`, `share` 1 gives `other`.
inline QColor mixedColor(const QColor& one, const QColor& other, double share) {
  return QColor::fromRgbF(static_cast<float>((1.0 - share) * one.redF() + share * other.redF()),
                          static_cast<float>((1.0 - share) * one.greenF() + share * other.greenF()),
                          static_cast<float>((1.0 - share) * one.blueF() + share * other.blueF()));
}

} // namespace dewpoint::ui
