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

/// Calibration with a wand. Holds the settings and the views collected live, runs the refinement in
/// another thread, and applies the result as one step of the document.
class WandCalibrator : public QObject {
  Q_OBJECT
public:
  /// Objects that the calibrator uses.
  struct Surroundings {
    Document& document;
    ManualCalibration& manual;
    Selection& selection;
    TargetListModel& targets;
    std::function<Result<SessionInputs>(const SessionRequest&)> open; ///< called in another thread
    std::function<Session*()> session; ///< returns the running session, or null
  };
  explicit WandCalibrator(Surroundings around, QObject* parent = nullptr);
  ~WandCalibrator() override;

  const WandSettings& settings() const { return settings_; }
  void setSettings(const WandSettings& settings);
  const Project& project() const;
  TargetListModel& targets() const { return around_.targets; }

  // Frames in which the ball touched the floor or an end of a distance, or fell.
  const std::vector<TouchedInstant>& touchedInstants() const { return touchedInstants_; }
  /// Adds the frame shown. A new end of a distance or a new fall replaces the previous one.
  void addTouchedInstant(TouchRole role);
  void removeTouchedInstant(std::size_t index);
  /// Shows the images of that frame.
  void showTouchedInstant(std::size_t index);
  /// Whether a frame is shown that can be added.
  bool canAddTouchedInstant() const { return shownFrame_ >= 0; }
  /// Whether a range of frames is selected in the timeline.
  bool hasSelectedRange() const { return around_.selection.selectedRange().has_value(); }

  // Live cameras.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  bool isLive() const { return live_; }
  bool isWaving() const { return waving_ != nullptr; }
  /// Starts collecting from scratch.
  void startWaving();
  void stopWaving();
  /// Returns the views collected so far, or nothing if nothing has been collected.
  std::optional<WandCollector::State> collected() const;

  // Refinement.
  /// Returns why the refinement cannot start; empty if it can.
  QString missing() const;
  void refine();
  void cancel();
  bool isRefining() const;
  /// The last refinement; null before the first one and after a failure.
  std::shared_ptr<const WandRefinement> refinement() const { return refinement_; }
  /// One sentence that explains why the last refinement gave no calibration.
  const QString& failure() const { return failure_; }
  /// Whether the cameras of the last refinement have been applied to the project.
  bool isApplied() const { return applied_; }
  /// Whether the cameras of the project have changed since the refinement was applied.
  bool isStale() const;
  void apply();
  void setFlipped(bool flipped);
  /// Writes the HTML report in another thread; `saved()` or `failed()` follows.
  void saveReport(const QString& file);

Q_SIGNALS:
  void changed();
  void collectedChanged();
  /// 0 to 1; negative: unknown.
  void progressChanged(double part);
  /// A refinement has ended, with or without a result.
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
  double shownSeconds_ = 0.0; ///< time of the frame shown on the clock of the calibration, seconds
  std::shared_ptr<WandCollector> collector_; ///< its thread may end after the window closes
  Session* waving_ = nullptr;                ///< session whose frames are collected; null: none
  std::shared_ptr<const WandRefinement> refinement_;
  QString failure_;
  bool applied_ = false;
  QTimer tick_;        ///< runs while collecting
  BackgroundJob* job_; ///< child of the calibrator; ends with it
};

} // namespace dewpoint::ui
