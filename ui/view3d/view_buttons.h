// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/scene3d.h"

#include <QCoreApplication>
#include <QObject>

#include <array>

class QToolButton;
class QWidget;

namespace dewpoint::ui {

/// Buttons in a corner of the view that select the viewing direction (3D, top, front, side), and a
/// button that fits the view to the whole scene.
class ViewButtons : public QObject {
  Q_OBJECT
public:
  explicit ViewButtons(QWidget& view);

  void setCurrentView(Scene3d::View view);
  void setShown(bool shown);
  /// Places the buttons in the lower left corner of the view.
  void moveToCorner();
  void retranslateUi();

Q_SIGNALS:
  void viewChosen(dewpoint::ui::Scene3d::View view);
  void fitRequested();

private:
  QWidget& view_;
  std::array<QToolButton*, 4> buttons_{}; ///< free, above, front, side
  QToolButton* fit_;
  bool shown_ = true;
};

} // namespace dewpoint::ui
