// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "core/setup/calibration/wand_collector.h"
#include "core/setup/calibration/wand_refinement.h"
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

/// Wand calibration. Holds the settings and the views collected live, runs the refinement in
/// another thread, and applies the result to the project in one undoable step.
class WandCalibrator : public QObject {
  Q_OBJECT
public:
  /// Objects that the calibrator uses.
  struct Dependencies {
    Document& document;
    ManualCalibration& manual;
    Selection& selection;
    TargetListModel& targets;
    /// Function that opens the recording of the document a second time. Called from another thread.
    std::function<Result<SessionInputs>(const SessionRequest&)> open;
    std::function<Session*()> session; ///< returns the running session, or null
  };
  explicit WandCalibrator(Dependencies around, QObject* parent = nullptr);
  ~WandCalibrator() override;

  const WandSettings& settings() const { return settings_; }
  void setSettings(const WandSettings& settings);
  const Project& project() const;
  TargetListModel& targets() const { return dependencies_.targets; }

  // Returns the frames that the user marked because the ball touched the floor, touched one end of
  // a known distance, or fell freely.
  const std::vector<MarkedInstant>& markedInstants() const { return markedInstants_; }
  /// Marks the frame shown as a frame in which the event `role` happens. The ball can touch the
  /// floor in several frames. Each other event, such as the beginning of a fall, happens once, so
  /// the frame replaces the one that was marked before.
  void markInstant(WandEvent role);
  void removeMarkedInstant(std::size_t index);
  /// Shows the images of one of the frames that the user has marked. `index` is the index in
  /// markedInstants().
  void showMarkedInstant(std::size_t index);
  /// Returns whether a frame is shown, so that it can be marked.
  bool canMarkInstant() const { return shownFrame_ >= 0; }
  /// Returns whether a range of frames is selected in the timeline.
  bool hasSelectedRange() const { return dependencies_.selection.selectedRange().has_value(); }

  // Live cameras.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  bool usesLiveCameras() const { return live_; }
  bool isCollectingViews() const { return waving_ != nullptr; }
  /// Starts to collect views of the wand from live cameras, from scratch.
  void startCollectingViews();
  void stopCollectingViews();
  /// Returns the views collected so far, or nothing if there are none.
  std::optional<WandCollector::State> collectorState() const;

  // Refinement.
  /// Returns the reason why the refinement cannot start, or an empty string if it can.
  QString reasonNotToRefine() const;
  void refine();
  void cancel();
  bool isRefining() const;
  /// Returns the result of the last refinement; null before the first one and after a failure.
  std::shared_ptr<const WandRefinement> refinement() const { return refinement_; }
  /// Returns one sentence that explains why the last refinement produced no calibration.
  const QString& failureText() const { return failure_; }
  /// Returns whether the cameras from the last refinement have been applied to the project.
  bool isApplied() const { return applied_; }
  /// Returns whether the project's cameras have changed since the refinement was applied.
  bool isStale() const;
  void apply();
  void setBeforeRefinementShown(bool shown);
  /// Writes the HTML report in another thread; emits `saved()` or `failed()` afterwards.
  void saveReport(const QString& file);

Q_SIGNALS:
  void changed();
  void collectorStateChanged();
  /// Emitted with the progress from 0 to 1; negative if unknown.
  void progressChanged(double fraction);
  /// Emitted when a refinement has ended, with or without a result.
  void refinementEnded();
  void saved(const QString& file);
  void failed(const QString& sentence);

private:
  void applyResult(Result<WandRefinement> outcome);
  void discardResults();
  void detachFromSession();

  Dependencies dependencies_;
  WandSettings settings_;
  std::vector<MarkedInstant> markedInstants_;
  bool live_ = false;
  qint64 shownFrame_ = -1;
  double shownSeconds_ = 0.0; ///< time of the frame shown, seconds on the calibration clock
  std::shared_ptr<WandCollector> collector_; ///< its thread may outlive the window
  Session* waving_ = nullptr;                ///< session whose frames are collected; null if none
  std::shared_ptr<const WandRefinement> refinement_;
  QString failure_;
  bool applied_ = false;
  QTimer tick_;        ///< runs while collecting
  BackgroundJob* job_; ///< child of the calibrator, which deletes it
};

} // namespace dewpoint::ui
