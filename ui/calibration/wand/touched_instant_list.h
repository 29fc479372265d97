// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

class QComboBox;
class QListWidget;
class QPushButton;

namespace dewpoint::ui {

class WandCalibrator;

/// Lists the frames that the user marked because the ball touched the floor, touched one end of a
/// known distance, or fell freely. The user can add the frame shown and remove frames.
class TouchedInstantList : public QWidget {
  Q_OBJECT
public:
  explicit TouchedInstantList(WandCalibrator& calibrator, QWidget* parent = nullptr);

private:
  void retranslateUi();
  void refresh();

  WandCalibrator& calibrator_;
  QComboBox* role_;
  QPushButton* take_;
  QListWidget* list_;
  QPushButton* remove_;
};

} // namespace dewpoint::ui
