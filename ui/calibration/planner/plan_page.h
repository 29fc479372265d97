// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

class QLabel;

namespace dewpoint::ui {

class RigPlanner;

/// Calibration dock page for planning a rig.
class PlanPage : public QWidget {
  Q_OBJECT
public:
  explicit PlanPage(RigPlanner& plan, QWidget* parent = nullptr);

private:
  void retranslateUi();

  QLabel* guide_;
  QLabel* mapTitle_;
  QLabel* cameraTitle_;
  QLabel* note_;
};

} // namespace dewpoint::ui
