// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/calibration_guide.h"

#include <QObject>

#include <optional>
#include <vector>

namespace dewpoint::ui {

class Document;

/// The way in which the user calibrates the project, and the current step. Progress follows from
/// the calibration status of the project, no matter how it was reached.
class CalibrationGuide : public QObject {
  Q_OBJECT
public:
  explicit CalibrationGuide(Document& document, QObject* parent = nullptr);

  const CalibrationStatus& status() const { return status_; }
  /// Returns the chosen way; nothing until the user has chosen one, or the project records how its
  /// cameras were calibrated (setup::wayTaken()).
  std::optional<CalibrationWay> way() const { return way_; }
  /// Chooses a way on behalf of the user, and goes to its first step that is not done.
  void setWay(CalibrationWay way);
  /// Returns whether the user follows the guide: has chosen a way, or has seen the guide (follow())
  /// while a way was known.
  bool isFollowed() const { return isFollowed_; }
  /// Records that the user sees the guide. Has no effect while no way is known.
  void follow();
  /// Returns the steps of the chosen way.
  std::vector<GuideStep> steps() const;
  /// Returns the progress of a step.
  StepProgress progress(GuideStep step) const;
  /// Returns the index of the current step in `steps()`.
  int current() const { return current_; }
  /// Makes a step the current one.
  void goTo(int index);

Q_SIGNALS:
  void changed();
  /// Emitted when the user wants to work on a step.
  void openRequested(dewpoint::setup::GuideStep step);

private:
  void refresh();
  void restart();
  void takeWay(CalibrationWay way);

  Document& document_;
  CalibrationStatus status_;
  std::optional<CalibrationWay> way_;
  bool isFollowed_ = false;
  int current_ = 0;
};

} // namespace dewpoint::ui
