// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/gallery_card.h"

#include "ui/start/start_colors.h"
#include "ui/style/spacing.h"
#include "ui/style/symbolic_icon.h"

#include <QEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace dewpoint::ui {

namespace {

// Pixels; chosen on the rhythm of the spacing.
constexpr int kCardCorner = 8;
constexpr int kCardPadding = 12;
constexpr int kLargeHeight = 192;
constexpr int kSymbolSize = 24;
constexpr int kCardLineGap = 4;
constexpr int kPlaySize = 48;
/// Shape of the pictures: width and height.
constexpr int kWide = 16;
constexpr int kHigh = 9;

/// A shape with the corners of the card, the right or lower ones only where nothing follows.
QPainterPath roundedPath(const QRectF& area, double corner) {
  QPainterPath path;
  path.addRoundedRect(area, corner, corner);
  return path;
}

/// The round sign that something plays when it is pressed.
void paintPlaySign(QPainter& painter, const QPointF& middle, const QPalette& palette) {
  constexpr double kRadius = 0.5 * kPlaySize;
  painter.setPen(QPen(palette.color(QPalette::HighlightedText), 1.5));
  painter.setBrush(palette.color(QPalette::Highlight));
  painter.drawEllipse(middle, kRadius, kRadius);
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette.color(QPalette::HighlightedText));
  const QPolygonF triangle{{QPointF(-6.0, -9.5), QPointF(10.0, 0.0), QPointF(-6.0, 9.5)}};
  painter.drawPolygon(triangle.translated(middle));
}

} // namespace

GalleryCard::GalleryCard(const char* name, CardLayout cardLayout, QWidget* parent)
    : QToolButton(parent), cardLayout_(cardLayout) {
  setObjectName(QLatin1String(name));
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
  setAttribute(Qt::WA_Hover);
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void GalleryCard::setPicture(const QString& name) {
  picture_ = QPixmap(QStringLiteral(":/gallery/%1.jpg").arg(name));
  shownPicture_ = {};
  update();
}

void GalleryCard::setSymbol(const QString& name) {
  symbol_ = name;
  drawSymbol();
}

void GalleryCard::drawSymbol() {
  if (!symbol_.isEmpty()) {
    setIcon(symbolicIcon(symbol_, palette()));
  }
}

void GalleryCard::setTexts(const QString& title, const QString& line) {
  setText(title);
  line_ = line;
  setAccessibleName(title);
  setAccessibleDescription(line);
  setToolTip(cardLayout_ == CardLayout::Row ? line : QString()); // the others have room to say it
  updateGeometry();
  update();
}

void GalleryCard::setBusy(bool busy) {
  busy_ = busy;
  setCursor(busy ? Qt::BusyCursor : Qt::PointingHandCursor);
  update();
}

QFont GalleryCard::titleFont() const {
  QFont title = font();
  title.setWeight(QFont::DemiBold);
  title.setPointSizeF(title.pointSizeF() * (cardLayout_ == CardLayout::Large ? 1.5 : 1.05));
  return title;
}

QString GalleryCard::lineShown() const {
  return busy_ ? tr("Opening…") : line_;
}

int GalleryCard::textHeight(int width) const {
  const QRect room(0, 0, std::max(1, width), QWIDGETSIZE_MAX);
  return QFontMetrics(titleFont()).boundingRect(room, Qt::TextWordWrap, text()).height() +
         kCardLineGap + fontMetrics().boundingRect(room, Qt::TextWordWrap, line_).height();
}

int GalleryCard::heightForWidth(int width) const {
  switch (cardLayout_) {
  case CardLayout::Tile:
    return width * kHigh / kWide + textHeight(width - 2 * kCardPadding) + 2 * kCardPadding;
  case CardLayout::Large:
    return kLargeHeight;
  case CardLayout::Row:
    break;
  }
  const int beside = 3 * kCardPadding + kSymbolSize;
  return std::max(kSymbolSize, textHeight(width - beside)) + 2 * kSpacing;
}

QSize GalleryCard::sizeHint() const {
  constexpr int kUsualWidth = 240;
  return {kUsualWidth, heightForWidth(kUsualWidth)};
}

QSize GalleryCard::minimumSizeHint() const {
  constexpr int kLeastWidth = 120;
  return {kLeastWidth, kSymbolSize + 2 * kSpacing};
}

void GalleryCard::paintTexts(QPainter& painter, const QRect& area) const {
  painter.setFont(titleFont());
  painter.setPen(palette().color(QPalette::Text));
  QRect used;
  painter.drawText(area, Qt::TextWordWrap | Qt::AlignTop, text(), &used);
  painter.setFont(font());
  painter.setPen(busy_ ? palette().color(QPalette::Link) : secondaryTextColor(palette()));
  painter.drawText(area.adjusted(0, used.height() + kCardLineGap, 0, 0),
                   Qt::TextWordWrap | Qt::AlignTop, lineShown());
}

void GalleryCard::paintPicture(QPainter& painter, const QRect& area) {
  const double ratio = devicePixelRatioF();
  const QSize size = area.size() * ratio;
  if (picture_.isNull() || size.isEmpty()) {
    return;
  }
  if (shownPicture_.size() != size) {
    const QPixmap scaled =
        picture_.scaled(size, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    shownPicture_ = QPixmap(size);
    shownPicture_.fill(Qt::transparent);
    QPainter clip(&shownPicture_);
    clip.setRenderHint(QPainter::Antialiasing);
    const double corner = (kCardCorner - 1) * ratio;
    QPainterPath shape = roundedPath(QRectF(QPointF(), size), corner);
    // The two corners at which the card goes on are square.
    cardLayout_ == CardLayout::Tile
        ? shape.addRect(0.0, 0.5 * size.height(), size.width(), 0.5 * size.height())
        : shape.addRect(0.5 * size.width(), 0.0, 0.5 * size.width(), size.height());
    shape.setFillRule(Qt::WindingFill);
    clip.fillPath(shape, Qt::black);
    clip.setCompositionMode(QPainter::CompositionMode_SourceIn);
    clip.drawPixmap((size.width() - scaled.width()) / 2, (size.height() - scaled.height()) / 2,
                    scaled);
    clip.end();
    shownPicture_.setDevicePixelRatio(ratio);
  }
  painter.drawPixmap(area.topLeft(), shownPicture_);
}

void GalleryCard::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor accent = palette().color(QPalette::Highlight);
  const QColor ground = palette().color(QPalette::Base);
  const bool marked = hasFocus() || busy_;
  const bool near = isEnabled() && underMouse();
  painter.setBrush(mixedColor(ground, accent, isDown() ? 0.18 : near ? 0.07 : 0.0));
  painter.setPen(Qt::NoPen);
  painter.drawRoundedRect(rect(), kCardCorner, kCardCorner);
  const QRect inside = rect().adjusted(1, 1, -1, -1);
  if (cardLayout_ == CardLayout::Tile) {
    const QRect above(inside.topLeft(), QSize(inside.width(), width() * kHigh / kWide));
    paintPicture(painter, above);
    paintTexts(painter, QRect(kCardPadding, above.bottom() + kCardPadding,
                              width() - 2 * kCardPadding, height() - above.bottom()));
  } else if (cardLayout_ == CardLayout::Large) {
    const int wide = std::min(inside.height() * kWide / kHigh, inside.width() * 11 / 20);
    const QRect left(inside.topLeft(), QSize(wide, inside.height()));
    paintPicture(painter, left);
    paintPlaySign(painter, QRectF(left).center(), palette());
    const QRect beside = inside.adjusted(wide + 2 * kCardPadding, 0, -2 * kCardPadding, 0);
    const int high = textHeight(beside.width());
    paintTexts(painter,
               beside.adjusted(0, std::max(kCardPadding, (beside.height() - high) / 2), 0, 0));
  } else {
    icon().paint(&painter, kCardPadding, (height() - kSymbolSize) / 2, kSymbolSize, kSymbolSize);
    const int left = 2 * kCardPadding + kSymbolSize;
    const int wide = width() - left - kCardPadding;
    paintTexts(painter, QRect(left, (height() - textHeight(wide)) / 2, wide, height()));
  }
  const double stroke = marked ? 2.0 : 1.0;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(marked || near ? accent : palette().color(QPalette::Mid), stroke));
  const double half = 0.5 * stroke;
  painter.drawRoundedRect(QRectF(rect()).adjusted(half, half, -half, -half), kCardCorner,
                          kCardCorner);
}

void GalleryCard::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    click();
    return;
  }
  QToolButton::keyPressEvent(event);
}

void GalleryCard::changeEvent(QEvent* event) {
  QToolButton::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    drawSymbol();
  }
}

} // namespace dewpoint::ui
