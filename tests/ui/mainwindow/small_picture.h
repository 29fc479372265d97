// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

namespace dewpoint::tests {

/// With 32 levels per color instead of 256: the noise of camera images makes PNG files large.
inline QImage withFewerLevels(const QImage& picture) {
  QImage fewer = picture.convertToFormat(QImage::Format_RGB32);
  for (int y = 0; y < fewer.height(); ++y) {
    auto* line = reinterpret_cast<QRgb*>(fewer.scanLine(y));
    for (int x = 0; x < fewer.width(); ++x) {
      const QRgb high = line[x] & 0xfff8f8f8U;
      line[x] = high | ((high & 0x00e0e0e0U) >> 5U); // black and white stay so
    }
  }
  return fewer;
}

} // namespace dewpoint::tests
