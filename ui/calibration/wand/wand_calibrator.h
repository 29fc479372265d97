// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "core/setup/wand_collector.h"
#include "core/setup/wand_refinement.h"
#include "ui/calibration/wand/wand_text.h"
#include "ui/selection/selection.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>

namespace dewpoint::ui {

class Document;
class ManualCalibration;
class TargetListModel;
class BackgroundJob;

/// Calibrating from a wand: what is decided, what was collected live, and the refinement
/// beside the window, whose result becomes one step of the document.
class WandCalibrator : public QObject {
  Q_OBJECT
public:
  /// What the calibrator works with.
  struct Surroundings {
    Document& document;
    ManualCalibration& hand;
    Selection& selection;
    TargetListModel& targets;
    std::function<Result<SessionInputs>(const SessionRequest&)> open; ///< called in a thread
    std::function<Session*()> session;                                ///< the running one, or null
  };
  explicit WandCalibrator(Surroundings around, QObject* parent = nullptr);
  ~WandCalibrator() override;

  const WandSettings& settings() const { return settings_; }
  void setSettings(const WandSettings& settings);
  const Project& project() const;
  TargetListModel& targets() const { return around_.targets; }

  // Frames in which the ball touched the floor or an end of a distance, or fell.
  const std::vector<TouchedInstant>& touchedInstants() const { return touchedInstants_; }
  /// Adds the frame shown; ends of a distance or a fall replace the former ones.
  void addTouchedInstant(TouchRole role);
  void removeTouchedInstant(std::size_t index);
  /// Shows the images of that frame.
  void showTouchedInstant(std::size_t index);
  /// Whether there is a frame to add.
  bool canAddTouchedInstant() const { return shownFrame_ >= 0; }
  /// Whether a range of frames is selected in the timeline.
  bool hasSelectedRange() const { return around_.selection.selectedRange().has_value(); }

  // Live cameras.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  bool isLive() const { return live_; }
  bool isWaving() const { return waving_ != nullptr; }
  /// Begins to collect, from scratch.
  void startWaving();
  void stopWaving();
  /// What was collected so far, if anything was.
  std::optional<WandCollector::State> collected() const;

  // Refining.
  /// Why it cannot begin; empty when it can.
  QString missing() const;
  void refine();
  void cancel();
  bool isRefining() const;
  /// The last refinement; null before there was one, and after a failure.
  std::shared_ptr<const WandRefinement> refinement() const { return refinement_; }
  /// What came of the last one, when that was no calibration: one sentence.
  const QString& failure() const { return failure_; }
  /// Whether the cameras of the last refinement were taken into the project.
  bool isApplied() const { return applied_; }
  /// Whether the cameras are others since than those that were found and applied.
  bool isStale() const;
  void apply();
  void setFlipped(bool flipped);
  /// Writes the HTML report in a thread; saved() or failed() follow.
  void saveReport(const QString& file);

Q_SIGNALS:
  void changed();
  void collectedChanged();
  /// 0 to 1; less: unknown.
  void progressChanged(double part);
  /// A refinement is over, whatever came of it.
  void refined();
  void saved(const QString& file);
  void failed(const QString& sentence);

private:
  void applyResult(Result<WandRefinement> outcome);
  void forget();
  void detachFromSession();

  Surroundings around_;
  WandSettings settings_;
  std::vector<TouchedInstant> touchedInstants_;
  bool live_ = false;
  qint64 shownFrame_ = -1;
  double shownSeconds_ = 0.0;                ///< its time, as the calibration will know it
  std::shared_ptr<WandCollector> collector_; ///< its thread ends beside the window
  Session* waving_ = nullptr;                ///< whose frames are collected
  std::shared_ptr<const WandRefinement> refinement_;
  QString failure_;
  bool applied_ = false;
  QTimer tick_;        ///< while collecting
  BackgroundJob* job_; ///< child: ends with the calibrator
};

} // namespace dewpoint::ui
