// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QPixmap>
#include <QToolButton>

namespace dewpoint::ui {

/// A flat button of the start page: a picture or an icon, a title, and one line that says what it
/// is for. Enter and Space press it; hover and focus are shown by its border.
class GalleryCard : public QToolButton {
  Q_OBJECT
public:
  enum class Form {
    Tile,  ///< picture above, texts below
    Large, ///< picture at the left, large texts beside it
    Row    ///< icon at the left, both texts beside it
  };
  GalleryCard(const char* name, Form form, QWidget* parent);

  /// The picture of a tile, from the resources: gallery/`name`.jpg.
  void setPicture(const QString& name);
  /// The icon of a row, from the resources: icons/`name`.svg.
  void setSymbol(const QString& name);
  void setTexts(const QString& title, const QString& line);
  /// While it opens what it is for, it says so in place of its line.
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
  /// How high title and line are, one above the other.
  int textHeight(int width) const;
  void paintTexts(QPainter& painter, const QRect& area) const;
  void paintPicture(QPainter& painter, const QRect& area);
  void drawSymbol();

  Form form_;
  QPixmap picture_;
  QPixmap shownPicture_; ///< the picture as it was drawn last, with its corners
  QString symbol_;
  QString line_;
  bool busy_ = false;
};

} // namespace dewpoint::ui
