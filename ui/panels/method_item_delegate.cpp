// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/method_item_delegate.h"

#include "ui/panels/method_choice.h"
#include "ui/style/type_scale.h"

#include <QFontMetrics>
#include <QPainter>

#include <algorithm>

namespace dewpoint::ui {

namespace {

constexpr int kMethodMargin = 10; ///< left and right of a line, pixels
constexpr int kMethodPadding = 6; ///< above and below the lines
constexpr int kMethodGap = 24;    ///< between the words and what stands at the right edge
constexpr int kLineGap = 2;       ///< between the two lines

bool isHeading(const QModelIndex& index) {
  return !index.data(Qt::UserRole).isValid();
}

/// The texts of a method, and how they are written.
struct MethodLines {
  explicit MethodLines(const QStyleOptionViewItem& option, const QModelIndex& index)
      : titleFont(mediumFont(option.font)), smallFont(smallerFont(option.font)),
        title(index.data().toString()), name(index.data(Qt::UserRole).toString()),
        sentence(index.data(MethodChoice::DescriptionRole).toString()),
        paper(index.data(MethodChoice::PaperRole).toString()) {}

  QFont titleFont;
  QFont smallFont;
  QString title;
  QString name;
  QString sentence;
  QString paper;
};

int widthOf(const QFont& font, const QString& text) {
  return QFontMetrics(font).horizontalAdvance(text);
}

/// One line: words at the left, as far as there is room, and a name at the right.
void drawLine(QPainter& painter, const QRect& line, const QFont& font, const QString& words,
              const QFont& nameFont, const QString& name, const QColor& ink, const QColor& faint) {
  const int taken = name.isEmpty() ? 0 : widthOf(nameFont, name) + kMethodGap;
  const QRect room = line.adjusted(0, 0, -taken, 0);
  painter.setFont(font);
  painter.setPen(ink);
  painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                   QFontMetrics(font).elidedText(words, Qt::ElideRight, room.width()));
  painter.setFont(nameFont);
  painter.setPen(faint);
  painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, name);
}

void drawHeading(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) {
  painter.setFont(headingFont(option.font));
  painter.setPen(option.palette.color(QPalette::Active, QPalette::Link));
  painter.drawText(option.rect.adjusted(kMethodMargin, 0, -kMethodMargin, -kLineGap),
                   Qt::AlignLeft | Qt::AlignBottom, index.data().toString());
}

} // namespace

void MethodItemDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index) const {
  painter->save();
  painter->fillRect(option.rect, option.palette.color(QPalette::Base));
  if (isHeading(index)) {
    drawHeading(*painter, option, index);
    painter->restore();
    return;
  }
  const MethodLines lines(option, index);
  const bool canBeChosen = index.flags().testFlag(Qt::ItemIsEnabled);
  const bool isLit = canBeChosen && option.state.testFlag(QStyle::State_Selected);
  const auto color = [&](QPalette::ColorRole role) {
    return option.palette.color(QPalette::Active, isLit ? QPalette::HighlightedText : role);
  };
  if (isLit) {
    painter->fillRect(option.rect, option.palette.color(QPalette::Active, QPalette::Highlight));
  }
  const QColor faint = color(QPalette::PlaceholderText);
  QRect line = option.rect.adjusted(kMethodMargin, kMethodPadding, -kMethodMargin, 0);
  line.setHeight(QFontMetrics(lines.titleFont).height());
  drawLine(*painter, line, lines.titleFont, lines.title, lines.smallFont, lines.name,
           canBeChosen ? color(QPalette::Text) : faint, faint);
  line.moveTop(line.bottom() + 1 + kLineGap);
  line.setHeight(QFontMetrics(lines.smallFont).height());
  drawLine(*painter, line, lines.smallFont, lines.sentence, lines.smallFont, lines.paper,
           canBeChosen ? color(QPalette::Text) : faint, faint);
  painter->restore();
}

QSize MethodItemDelegate::sizeHint(const QStyleOptionViewItem& option,
                                   const QModelIndex& index) const {
  if (isHeading(index)) {
    const QFontMetrics metrics(headingFont(option.font));
    return {metrics.horizontalAdvance(index.data().toString()) + 2 * kMethodMargin,
            metrics.height() + 10};
  }
  const MethodLines lines(option, index);
  const auto width = [](const QFont& font, const QString& words, const QFont& nameFont,
                        const QString& name) {
    return widthOf(font, words) + (name.isEmpty() ? 0 : kMethodGap + widthOf(nameFont, name));
  };
  return {std::max(width(lines.titleFont, lines.title, lines.smallFont, lines.name),
                   width(lines.smallFont, lines.sentence, lines.smallFont, lines.paper)) +
              2 * kMethodMargin,
          QFontMetrics(lines.titleFont).height() + kLineGap +
              QFontMetrics(lines.smallFont).height() + 2 * kMethodPadding};
}

} // namespace dewpoint::ui
