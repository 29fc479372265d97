// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

#include <array>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace dewpoint::ui {

class RigPlanner;

/// Fields for the planned cameras, and the search for the best position of an additional camera.
class PlannerForm : public QWidget {
  Q_OBJECT
public:
  explicit PlannerForm(RigPlanner& plan, QWidget* parent = nullptr);

private:
  void createWidgets();
  void connectFields();
  void connectSearch();
  void retranslateUi();
  void refresh();
  void refreshNames();
  void editPosition(int axis, double value);
  void editTarget(int axis, double value);
  void editLens();

  RigPlanner& plan_;
  QPushButton* add_;
  QPushButton* remove_;
  QLabel* cameraLabel_;
  QComboBox* camera_;
  QLabel* positionLabel_;
  std::array<QDoubleSpinBox*, 3> position_;
  QLabel* targetLabel_;
  std::array<QDoubleSpinBox*, 3> target_;
  QLabel* lensLabel_;
  QDoubleSpinBox* fieldOfView_;
  QDoubleSpinBox* imageWidth_;
  QDoubleSpinBox* imageHeight_;
  QPushButton* find_;
  QLabel* wallLabel_;
  QDoubleSpinBox* wall_;
  QProgressBar* progress_;
  QPushButton* cancel_;
  QLabel* message_;
};

} // namespace dewpoint::ui
