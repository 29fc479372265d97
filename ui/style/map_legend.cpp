// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/map_legend.h"

#include "ui/style/to_color.h"
#include "ui/text/quantity_text.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPalette>
#include <QRect>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {
namespace {

constexpr int kMargin = 8;
constexpr int kPadding = 6;

struct Entry {
  QColor color; ///< invalid: nothing is drawn of it
  QString text;
};

std::vector<Entry> entries(const MapOptions& look) {
  const std::vector<MapClass> classes = mapClasses(look);
  const bool counts = look.quantity == MapQuantity::CameraCount;
  std::vector<Entry> all;
  double before = 0.0;
  for (const MapClass& one : classes) {
    const bool last = !std::isfinite(one.upperBound);
    QString text;
    if (counts) {
      text = last ? QCoreApplication::translate("MapLegend", "%1 or more").arg(int(before) + 1)
                  : QString::number(int(one.upperBound));
    } else {
      text = last ? QStringLiteral("> ") + lengthText(before, LengthForm::Short)
                  : QStringLiteral("≤ ") + lengthText(one.upperBound, LengthForm::Short);
    }
    all.push_back({toQColor(one.color), text});
    before = one.upperBound;
  }
  all.push_back(
      {QColor(),
       counts ? QCoreApplication::translate("MapLegend", "blank: seen by no camera")
              : QCoreApplication::translate("MapLegend", "blank: seen by fewer than two cameras")});
  return all;
}

} // namespace

void paintMapLegend(QPainter& painter, const QRect& area, const MapOptions& look,
                    const QPalette& palette) {
  painter.save();
  const QString title = look.quantity == MapQuantity::CameraCount
                            ? QCoreApplication::translate("MapLegend", "Cameras that see a point")
                            : QCoreApplication::translate("MapLegend", "Expected error (1 σ)");
  const std::vector<Entry> all = entries(look);
  const QFontMetrics metrics = painter.fontMetrics();
  const int line = metrics.height() + 2;
  const int swatch = metrics.height() + 4;
  int width = metrics.horizontalAdvance(title);
  for (const Entry& entry : all) {
    const int before = entry.color.isValid() ? swatch + kPadding : 0;
    width = std::max(width, before + metrics.horizontalAdvance(entry.text));
  }
  const QRect box(area.right() - kMargin - width - 2 * kPadding, area.top() + kMargin,
                  width + 2 * kPadding, line * int(all.size() + 1) + 2 * kPadding);
  QColor ground = palette.color(QPalette::Base);
  ground.setAlphaF(0.85F);
  painter.setPen(palette.color(QPalette::Mid));
  painter.setBrush(ground);
  painter.drawRect(box);
  const QColor ink = palette.color(QPalette::Text);
  QRect row(box.left() + kPadding, box.top() + kPadding, width, line);
  painter.setPen(ink);
  painter.drawText(row, Qt::AlignVCenter | Qt::AlignLeft, title);
  for (const Entry& entry : all) {
    row.translate(0, line);
    int left = 0;
    if (entry.color.isValid()) {
      painter.fillRect(QRect(row.left(), row.top() + 1, swatch, line - 2), entry.color);
      left = swatch + kPadding;
    }
    painter.drawText(row.adjusted(left, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, entry.text);
  }
  painter.restore();
}

} // namespace dewpoint::ui
