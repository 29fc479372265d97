// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/target_row_delegate.h"

#include "ui/style/tabular_font.h"
#include "ui/style/type_scale.h"
#include "ui/text/tracking_state_text.h"

#include <QAbstractItemView>
#include <QFontMetrics>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include <utility>

namespace dewpoint::ui {

namespace {

constexpr int kRowMargin = 8;   ///< left and right, pixels
constexpr int kRowPadding = 5;  ///< above and below
constexpr int kSwatchSide = 18; ///< of the disc with its ring
constexpr double kRing = 2.5;
constexpr int kEyeSide = 18;

void drawSwatch(QPainter& painter, const QRectF& place, const TargetRow& row) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(row.identityColor, kRing));
  painter.setBrush(row.learnedColor.value_or(row.identityColor));
  painter.drawEllipse(place.adjusted(kRing / 2.0, kRing / 2.0, -kRing / 2.0, -kRing / 2.0));
}

/// An eye, crossed out if the target is hidden.
void drawEye(QPainter& painter, const QRectF& place, bool isOpen, const QColor& ink) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(ink, 1.3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  const QRectF eye = place.adjusted(2.0, 4.0, -2.0, -4.0);
  const QPointF left(eye.left(), eye.center().y());
  const QPointF right(eye.right(), eye.center().y());
  QPainterPath lids(left);
  lids.quadTo(QPointF(eye.center().x(), eye.top() - 2.5), right);
  lids.quadTo(QPointF(eye.center().x(), eye.bottom() + 2.5), left);
  painter.drawPath(lids);
  painter.drawEllipse(eye.center(), 2.0, 2.0);
  if (!isOpen) {
    painter.drawLine(place.bottomLeft() + QPointF(3.0, -3.0),
                     place.topRight() - QPointF(3.0, -3.0));
  }
}

} // namespace

bool TargetRowDelegate::setRows(std::vector<TargetRow> rows) {
  if (rows == rows_) {
    return false;
  }
  rows_ = std::move(rows);
  return true;
}

void TargetRowDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const {
  const auto number = static_cast<std::size_t>(index.row());
  const TargetRow row = number < rows_.size() ? rows_[number] : TargetRow();
  const bool isChosen = option.state.testFlag(QStyle::State_Selected);
  painter->save();
  if (isChosen) {
    painter->fillRect(option.rect, option.palette.color(QPalette::Highlight));
  }
  const auto ink = [&](QPalette::ColorRole role) {
    return option.palette.color(isChosen ? QPalette::HighlightedText : role);
  };
  const QRect inner = option.rect.adjusted(kRowMargin, kRowPadding, -kRowMargin, -kRowPadding);
  const QFont name = mediumFont(option.font);
  const QFont small = smallerFont(option.font);
  drawSwatch(
      *painter,
      QRectF(inner.left(), inner.center().y() - kSwatchSide / 2.0 + 0.5, kSwatchSide, kSwatchSide),
      row);
  drawEye(*painter, eyeIconArea(option.rect), row.isShown,
          ink(row.isShown ? QPalette::PlaceholderText : QPalette::Text));
  QRect line = inner.adjusted(kSwatchSide + kRowMargin, 0, -kEyeSide - kRowMargin, 0);
  line.setHeight(QFontMetrics(name).height());
  const QString state = row.state ? trackingStateText(*row.state) : QString();
  painter->setFont(option.font);
  painter->setPen(row.state && !isChosen ? trackingStateColor(*row.state, option.palette)
                                         : ink(QPalette::Text));
  painter->drawText(line, Qt::AlignRight | Qt::AlignVCenter, state);
  const int room = line.width() - option.fontMetrics.horizontalAdvance(state) - kRowMargin;
  painter->setFont(name);
  painter->setPen(ink(row.isShown ? QPalette::Text : QPalette::PlaceholderText));
  painter->drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                    QFontMetrics(name).elidedText(index.data().toString(), Qt::ElideRight, room));
  line.moveTop(line.bottom() + 1);
  line.setHeight(QFontMetrics(small).height());
  const QFont digits = tabularFont(small); // the speed changes with every frame
  painter->setFont(digits);
  painter->setPen(ink(QPalette::Text));
  painter->drawText(line, Qt::AlignRight | Qt::AlignVCenter, row.speedText);
  const int left =
      line.width() - QFontMetrics(digits).horizontalAdvance(row.speedText) - kRowMargin;
  painter->setFont(small);
  painter->setPen(ink(QPalette::PlaceholderText));
  painter->drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                    QFontMetrics(small).elidedText(row.sizeText, Qt::ElideRight, left));
  painter->restore();
}

QRect TargetRowDelegate::eyeIconArea(const QRect& row) {
  QRect area(0, 0, kEyeSide, kEyeSide);
  area.moveCenter(row.center());
  area.moveRight(row.right() - kRowMargin);
  return area;
}

bool TargetRowDelegate::editorEvent(QEvent* event, QAbstractItemModel* model,
                                    const QStyleOptionViewItem& option, const QModelIndex& index) {
  const bool isClick = event->type() == QEvent::MouseButtonRelease;
  if (isClick || event->type() == QEvent::MouseButtonPress ||
      event->type() == QEvent::MouseButtonDblClick) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if (mouse->button() == Qt::LeftButton &&
        eyeIconArea(option.rect).contains(mouse->position().toPoint())) {
      if (isClick) {
        Q_EMIT eyeIconClicked(index.row());
      }
      return true;
    }
  }
  return QStyledItemDelegate::editorEvent(event, model, option, index);
}

bool TargetRowDelegate::helpEvent(QHelpEvent* event, QAbstractItemView* view,
                                  const QStyleOptionViewItem& option, const QModelIndex& index) {
  const auto row = static_cast<std::size_t>(index.row());
  if (event->type() != QEvent::ToolTip || row >= rows_.size() ||
      !eyeIconArea(option.rect).contains(event->pos())) {
    return QStyledItemDelegate::helpEvent(event, view, option, index);
  }
  QToolTip::showText(event->globalPos(),
                     rows_[row].isShown
                         ? tr("Hide this target in the images and in the bird's-eye view. It is "
                              "still tracked.")
                         : tr("Show this target in the images and in the bird's-eye view"),
                     view);
  return true;
}

QSize TargetRowDelegate::sizeHint(const QStyleOptionViewItem& option,
                                  const QModelIndex& /*index*/) const {
  return {10 * kSwatchSide, QFontMetrics(mediumFont(option.font)).height() +
                                QFontMetrics(smallerFont(option.font)).height() + 2 * kRowPadding};
}

} // namespace dewpoint::ui
