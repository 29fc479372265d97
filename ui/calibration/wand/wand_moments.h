// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

class QComboBox;
class QListWidget;
class QPushButton;

namespace dewpoint::ui {

class WandCalibrator;

/// Moments at which the ball touched the floor, an end of a known distance, or fell: taken from the
/// images shown, listed, removed.
class WandMoments : public QWidget {
  Q_OBJECT
public:
  explicit WandMoments(WandCalibrator& calibrator, QWidget* parent = nullptr);

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
