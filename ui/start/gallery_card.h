// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QPixmap>
#include <QToolButton>

namespace dewpoint::ui {

/// Flat button on the start page with an image or an icon, a title, and a line that describes it.
/// Enter and Space press it. Its border shows hover and focus.
class GalleryCard : public QToolButton {
  Q_OBJECT
public:
  enum class CardLayout {
    Tile,  ///< image above the texts
    Large, ///< image on the left, large texts next to it
    Row    ///< icon on the left, both texts next to it
  };
  GalleryCard(const char* name, CardLayout cardLayout, QWidget* parent);

  /// Sets the image of a tile to the resource gallery/`name`.jpg.
  void setPicture(const QString& name);
  /// Sets the icon of a row to the resource icons/`name`.svg.
  void setSymbol(const QString& name);
  void setTexts(const QString& title, const QString& line);
  /// Sets whether the project of this card is being opened. If so, another text replaces the card's
  /// description.
  void setBusy(bool busy);
  bool isBusy() const { return busy_; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  QFont titleFont() const;
  QString lineShown() const;
  /// Returns the height in pixels of the title with the describing line below it.
  int textHeight(int width) const;
  void paintTexts(QPainter& painter, const QRect& area) const;
  void paintPicture(QPainter& painter, const QRect& area);
  void drawSymbol();

  CardLayout cardLayout_;
  QPixmap picture_;
  QPixmap shownPicture_; ///< image as last drawn, with rounded corners
  QString symbol_;
  QString line_;
  bool busy_ = false;
};

} // namespace dewpoint::ui
