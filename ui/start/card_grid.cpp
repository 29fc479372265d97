// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/card_grid.h"

#include "ui/start/gallery_card.h"

#include <QEvent>

#include <algorithm>

namespace dewpoint::ui {

namespace {

// Pixels; chosen.
constexpr int kCardGap = 16;
constexpr int kNarrowestCard = 168;
constexpr int kMostColumns = 3;

} // namespace

CardGrid::CardGrid(QWidget* parent) : QWidget(parent) {
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void CardGrid::add(GalleryCard* card) {
  card->setParent(this);
  cards_.push_back(card);
  updateGeometry();
}

int CardGrid::columns(int width) const {
  return std::clamp((width + kCardGap) / (kNarrowestCard + kCardGap), 1, kMostColumns);
}

QSize CardGrid::cardSize(int width) const {
  const int beside = columns(width);
  const int wide = (width - (beside - 1) * kCardGap) / beside;
  int high = 0;
  for (const GalleryCard* card : cards_) {
    high = std::max(high, card->heightForWidth(wide));
  }
  return {wide, high};
}

int CardGrid::heightForWidth(int width) const {
  const int beside = columns(width);
  const int rows = (static_cast<int>(cards_.size()) + beside - 1) / beside;
  return rows * cardSize(width).height() + (rows - 1) * kCardGap;
}

QSize CardGrid::sizeHint() const {
  constexpr int kUsualCard = 256;
  const int width = kMostColumns * kUsualCard + (kMostColumns - 1) * kCardGap;
  return {width, heightForWidth(width)};
}

QSize CardGrid::minimumSizeHint() const {
  return {kNarrowestCard, 0};
}

void CardGrid::arrange() {
  const QSize size = cardSize(width());
  const int beside = columns(width());
  for (int k = 0; k < static_cast<int>(cards_.size()); ++k) {
    cards_[static_cast<std::size_t>(k)]->setGeometry(QRect(
        QPoint((k % beside) * (size.width() + kCardGap), (k / beside) * (size.height() + kCardGap)),
        size));
  }
}

void CardGrid::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

bool CardGrid::event(QEvent* event) {
  if (event->type() == QEvent::LayoutRequest) { // a card has other texts
    updateGeometry();
    arrange();
  }
  return QWidget::event(event);
}

} // namespace dewpoint::ui
