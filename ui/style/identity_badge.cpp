// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/identity_badge.h"

#include "core/session/people/people_overlay.h"

#include <QPainter>

#include <algorithm>

namespace dewpoint::ui {

QColor personColor(int identity) {
  const cv::Scalar color = identityColor(identity); // blue, green, red
  return {static_cast<int>(color[2]), static_cast<int>(color[1]), static_cast<int>(color[0])};
}

QColor readableColorOn(const QColor& ground) {
  // Rec. 709 luma, without gamma: good enough to choose between two.
  const double luma = 0.2126 * ground.redF() + 0.7152 * ground.greenF() + 0.0722 * ground.blueF();
  return luma > 0.5 ? QColor(Qt::black) : QColor(Qt::white);
}

void paintIdentityBadge(QPainter& painter, int identity, const QPointF& foot, const QRectF& room,
                        bool chosen) {
  const QColor ground = personColor(identity);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  QFont bold = painter.font();
  bold.setWeight(QFont::Bold);
  painter.setFont(bold);
  const QString text = QString::number(identity);
  const double height = painter.fontMetrics().height() + 2.0;
  const double width = std::max(height, painter.fontMetrics().horizontalAdvance(text) + 10.0);
  QRectF badge(foot.x() - width / 2.0, foot.y() - height, width, height);
  badge.moveLeft(std::clamp(badge.left(), room.left() + 2.0,
                            std::max(room.left() + 2.0, room.right() - width - 2.0)));
  badge.moveTop(std::clamp(badge.top(), room.top() + 2.0,
                           std::max(room.top() + 2.0, room.bottom() - height - 2.0)));
  painter.setPen(QPen(chosen ? QColor(Qt::white) : QColor(0, 0, 0, 150), chosen ? 2.0 : 1.4));
  painter.setBrush(ground);
  painter.drawRoundedRect(badge, height / 2.0, height / 2.0);
  painter.setPen(readableColorOn(ground));
  painter.drawText(badge, Qt::AlignCenter, text);
  painter.restore();
}

} // namespace dewpoint::ui
