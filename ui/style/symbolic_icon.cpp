// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/symbolic_icon.h"

#include <QFile>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QSvgRenderer>

namespace dewpoint::ui {

namespace {

QPixmap drawn(QByteArray svg, const QColor& color, int size) {
  svg.replace("currentColor", color.name().toLatin1());
  QSvgRenderer renderer(svg);
  QPixmap pixmap(size, size);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  renderer.render(&painter);
  return pixmap;
}

} // namespace

QIcon symbolicIcon(const QString& name, const QPalette& palette) {
  QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
  if (!file.open(QIODevice::ReadOnly)) {
    return {};
  }
  const QByteArray svg = file.readAll();
  QIcon icon;
  for (const int size : {16, 20, 24, 32, 40, 48, 64, 96}) {
    icon.addPixmap(drawn(svg, palette.color(QPalette::ButtonText), size), QIcon::Normal);
    icon.addPixmap(drawn(svg, palette.color(QPalette::Disabled, QPalette::ButtonText), size),
                   QIcon::Disabled);
  }
  return icon;
}

} // namespace dewpoint::ui
