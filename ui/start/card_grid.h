// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

#include <vector>

namespace dewpoint::ui {

class GalleryCard;

/// Grid of cards of equal size, with as many columns as fit.
class CardGrid : public QWidget {
public:
  explicit CardGrid(QWidget* parent = nullptr);

  /// Adds a card to the grid and takes ownership of the card.
  void add(GalleryCard* card);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  int columns(int width) const;
  QSize cardSize(int width) const;
  void arrange();

  std::vector<GalleryCard*> cards_;
};

} // namespace dewpoint::ui
