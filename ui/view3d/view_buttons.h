// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/scene3d.h"

#include <QCoreApplication>
#include <QObject>

#include <array>

class QToolButton;
class QWidget;

namespace dewpoint::ui {

/// The buttons in a corner of the picture that choose the view: from above, from the front, free.
class ViewButtons : public QObject {
  Q_OBJECT
public:
  explicit ViewButtons(QWidget& view);

  void setCurrent(Scene3d::View view);
  void setShown(bool shown);
  /// Puts them into the lower left corner of the view.
  void place();
  void retranslate();

Q_SIGNALS:
  void chosen(dewpoint::ui::Scene3d::View view);

private:
  QWidget& view_;
  std::array<QToolButton*, 3> buttons_{}; ///< above, front, free
  bool shown_ = true;
};

} // namespace dewpoint::ui
