// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"

#include <QString>
#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;

namespace dewpoint::ui {

/// Row that shows the estimated delay of a camera, and a button that stores this delay in the
/// project. The row is hidden while nothing is estimated.
class DelayEstimate : public QWidget {
  Q_OBJECT
public:
  explicit DelayEstimate(QWidget* parent = nullptr);

  /// Sets the estimate shown. Delays are relative to the first camera, whose name is `firstCamera`.
  /// The row is hidden for the first camera itself, and if `estimate` is empty.
  void setEstimate(const std::optional<ClockEstimate>& estimate, const QString& firstCamera);
  /// Sets whether the estimate may be stored in the project.
  void setEditable(bool editable);

Q_SIGNALS:
  /// Emitted when the user wants to add the estimated delay (seconds) to the delay of the camera in
  /// the project.
  void delayAccepted(double delay);

private:
  void retranslateUi();
  void refresh();

  QLabel* text_;
  QPushButton* keep_;
  std::optional<ClockEstimate> estimate_;
  QString firstCamera_;
};

} // namespace dewpoint::ui
