// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;

namespace dewpoint {

class HandDesk;
class PointDesk;

/// The page of the calibration place for adjusting cameras by hand.
class HandPage : public QWidget {
  Q_OBJECT
public:
  HandPage(HandDesk& hand, PointDesk& points, QWidget* parent = nullptr);

private:
  void say();

  QLabel* guide_;
  QLabel* remark_;
  QLabel* cameraTitle_;
  QLabel* gridTitle_;
  QLabel* pointsTitle_;
};

} // namespace dewpoint
