// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/target_row_delegate.h"

#include "ui/style/tabular_font.h"
#include "ui/style/type_scale.h"
#include "ui/text/hold_text.h"

#include <QFontMetrics>
#include <QPainter>

#include <utility>

namespace dewpoint::ui {

namespace {

constexpr int kRowMargin = 8;   ///< left and right, pixels
constexpr int kRowPadding = 5;  ///< above and below
constexpr int kSwatchSide = 18; ///< of the disc with its ring
constexpr double kRing = 2.5;

void drawSwatch(QPainter& painter, const QRectF& place, const TargetRow& row) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(row.identity, kRing));
  painter.setBrush(row.learned.value_or(row.identity));
  painter.drawEllipse(place.adjusted(kRing / 2.0, kRing / 2.0, -kRing / 2.0, -kRing / 2.0));
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
  QRect line = inner.adjusted(kSwatchSide + kRowMargin, 0, 0, 0);
  line.setHeight(QFontMetrics(name).height());
  const QString state = row.state ? holdText(*row.state) : QString();
  painter->setFont(option.font);
  painter->setPen(row.state && !isChosen ? holdColor(*row.state, option.palette)
                                         : ink(QPalette::Text));
  painter->drawText(line, Qt::AlignRight | Qt::AlignVCenter, state);
  const int room = line.width() - option.fontMetrics.horizontalAdvance(state) - kRowMargin;
  painter->setFont(name);
  painter->setPen(ink(QPalette::Text));
  painter->drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                    QFontMetrics(name).elidedText(index.data().toString(), Qt::ElideRight, room));
  line.moveTop(line.bottom() + 1);
  line.setHeight(QFontMetrics(small).height());
  const QFont digits = tabularFont(small); // the speed changes with every frame
  painter->setFont(digits);
  painter->setPen(ink(QPalette::Text));
  painter->drawText(line, Qt::AlignRight | Qt::AlignVCenter, row.speed);
  const int left = line.width() - QFontMetrics(digits).horizontalAdvance(row.speed) - kRowMargin;
  painter->setFont(small);
  painter->setPen(ink(QPalette::PlaceholderText));
  painter->drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                    QFontMetrics(small).elidedText(row.size, Qt::ElideRight, left));
  painter->restore();
}

QSize TargetRowDelegate::sizeHint(const QStyleOptionViewItem& option,
                                  const QModelIndex& /*index*/) const {
  return {10 * kSwatchSide, QFontMetrics(mediumFont(option.font)).height() +
                                QFontMetrics(smallerFont(option.font)).height() + 2 * kRowPadding};
}

} // namespace dewpoint::ui
