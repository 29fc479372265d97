// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/calibration_guide.h"

#include <QObject>

#include <optional>
#include <vector>

namespace dewpoint::ui {

class Document;

/// State of the calibration guide: the way (procedure) that the user has chosen to calibrate the
/// project, and its current step. The progress of a step follows from what is known about the
/// calibration, no matter how it was obtained.
class CalibrationGuide : public QObject {
  Q_OBJECT
public:
  explicit CalibrationGuide(Document& document, QObject* parent = nullptr);

  const CalibrationStatus& status() const { return status_; }
  /// Returns the chosen way to calibrate. Returns nothing if the user has not chosen a way and the
  /// project does not record how its cameras were calibrated (setup::procedureInUse()).
  std::optional<CalibrationProcedure> procedure() const { return procedure_; }
  /// Sets the way that the user has chosen, and makes its first unfinished step the current one.
  void setProcedure(CalibrationProcedure procedure);
  /// Returns whether the user follows the guide. This is true after the user has chosen a way, or
  /// has seen the guide (follow()) while a way was known.
  bool isFollowed() const { return isFollowed_; }
  /// Records that the user has seen the guide. Has no effect while no way is known.
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
  /// Emitted when the user wants to work on a step, so that its page must be opened.
  void openRequested(dewpoint::setup::GuideStep step);

private:
  void refresh();
  void restart();
  void adoptProcedure(CalibrationProcedure procedure);

  Document& document_;
  CalibrationStatus status_;
  std::optional<CalibrationProcedure> procedure_;
  bool isFollowed_ = false;
  int current_ = 0;
};

} // namespace dewpoint::ui
