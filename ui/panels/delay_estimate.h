// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"

#include <QString>
#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;

namespace dewpoint::ui {

/// Row that shows the estimated delay of a camera, and a button that keeps it in the project. It is
/// hidden while nothing is estimated.
class DelayEstimate : public QWidget {
  Q_OBJECT
public:
  explicit DelayEstimate(QWidget* parent = nullptr);

  /// Sets the estimate shown and the name of the first camera, to which it is relative. Nothing is
  /// shown for the first camera itself, and if `estimate` is empty.
  void setEstimate(const std::optional<ClockEstimate>& estimate, const QString& firstCamera);
  /// Sets whether the estimate may be kept.
  void setEditable(bool editable);

Q_SIGNALS:
  /// Emitted when the user wants to add the estimated delay (seconds) to that of the camera.
  void kept(double delay);

private:
  void retranslateUi();
  void refresh();

  QLabel* text_;
  QPushButton* keep_;
  std::optional<ClockEstimate> estimate_;
  QString firstCamera_;
};

} // namespace dewpoint::ui
