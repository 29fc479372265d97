// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/symbolic_icon.h"

#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QPixmapCache>
#include <QSvgRenderer>

namespace dewpoint::ui {

namespace {

QString symbolFile(const QString& name) {
  return QStringLiteral(":/icons/%1.svg").arg(name);
}

QPixmap drawnSymbol(const QString& name, const QColor& color, const QSize& size) {
  QPixmap pixmap(size);
  pixmap.fill(Qt::transparent);
  QFile file(symbolFile(name));
  if (!file.open(QIODevice::ReadOnly)) {
    return pixmap;
  }
  QByteArray svg = file.readAll();
  svg.replace("currentColor", color.name().toLatin1());
  QSvgRenderer renderer(svg);
  renderer.setAspectRatioMode(Qt::KeepAspectRatio);
  QPainter painter(&pixmap);
  renderer.render(&painter);
  return pixmap;
}

/// Draws an icon at a size when that size is first shown. The window has many more icons than are
/// visible, and a change of theme replaces all of them.
class SymbolicIconEngine : public QIconEngine {
public:
  SymbolicIconEngine(QString name, QColor color, QColor disabledColor)
      : name_(std::move(name)), color_(color), disabledColor_(disabledColor) {}

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State /*state*/) override {
    if (size.isEmpty()) {
      return {};
    }
    const QColor& color = mode == QIcon::Disabled ? disabledColor_ : color_;
    const QString cacheKey = QStringLiteral("dewpoint-%1-%2-%3x%4")
                                 .arg(name_, color.name())
                                 .arg(size.width())
                                 .arg(size.height());
    QPixmap pixmap;
    if (!QPixmapCache::find(cacheKey, &pixmap)) {
      pixmap = drawnSymbol(name_, color, size);
      QPixmapCache::insert(cacheKey, pixmap);
    }
    return pixmap;
  }

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    const double ratio = painter->device()->devicePixelRatio();
    painter->drawPixmap(rect, pixmap(rect.size() * ratio, mode, state));
  }

  QIconEngine* clone() const override { return new SymbolicIconEngine(*this); }

private:
  QString name_;
  QColor color_;
  QColor disabledColor_;
};

} // namespace

QIcon symbolicIcon(const QString& name, const QPalette& palette) {
  if (!QFile::exists(symbolFile(name))) {
    return {};
  }
  return QIcon(new SymbolicIconEngine(name, palette.color(QPalette::ButtonText),
                                      palette.color(QPalette::Disabled, QPalette::ButtonText)));
}

} // namespace dewpoint::ui
