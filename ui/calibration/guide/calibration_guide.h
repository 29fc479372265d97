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
  /// Returns the chosen calibration procedure. Returns nothing if the user has not chosen one and
  /// the project does not record how its cameras were calibrated (setup::procedureInUse()).
  std::optional<CalibrationProcedure> procedure() const { return procedure_; }
  /// Sets the procedure that the user has chosen, and makes its first unfinished step current.
  void setProcedure(CalibrationProcedure procedure);
  /// Returns whether the guide is in use. It is in use once the user has chosen a procedure, or
  /// once the guide was opened (markOpened()) when procedure() was already known.
  bool isInUse() const { return isInUse_; }
  /// Records that the guide was opened. Has no effect while procedure() is unknown.
  void markOpened();
  /// Returns the steps of the chosen way (procedure) to calibrate.
  std::vector<GuideStep> steps() const;
  /// Returns the progress of a step.
  StepProgress progressOf(GuideStep step) const;
  /// Returns the index of the current step in `steps()`.
  int currentStep() const { return current_; }
  /// Makes a step the current one.
  void goToStep(int index);

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
  bool isInUse_ = false;
  int current_ = 0;
};

} // namespace dewpoint::ui
