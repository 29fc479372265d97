// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/frames/live_set.h"
#include "core/session/log/log_update.h"
#include "core/session/log/thinned_log.h"
#include "core/session/people/people_frame.h"
#include "core/session/run/box_track_file.h"
#include "core/session/run/result_settings.h"
#include "core/session/run/run_report.h"
#include "core/session/snapshot/snapshot.h"
#include "core/trajectory/trajectory.h"

#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::session {

/// Log of a run since its last start or restart. The tracking thread writes the log; other threads
/// copy from it.
class RunLog {
public:
  /// Maximum number of iteration records in the log, which take about 40 MB with four cameras.
  static constexpr std::size_t kMaxIterationRecords = 100000;
  RunLog();
  /// Clears the log. The records appended next are results of `project`, tracked with `threads`
  /// filter threads.
  void restart(const Project& project, int threads = 1);
  /// Replaces the project after its parameters, corrections or names have changed. If no frame is
  /// recorded yet, the header of the trajectory is replaced too. If a target was renamed, its name
  /// in all samples so far is replaced, and readers receive all records again.
  void updateProject(const Project& project);
  void append(const std::vector<IterationRecord>& records);
  /// Appends the samples of one frame. If this frame is already the last one in the log, its former
  /// samples are replaced.
  void append(const std::vector<TrajectorySample>& samples);
  /// Appends the boxes of one frame. If this frame is already the last one in the log, its former
  /// boxes are replaced.
  void append(const std::vector<BoxSample>& samples);
  /// Adds the duration of one filter iteration, in seconds per target.
  void countIteration(double seconds);
  /// Counts a finished frame. `sinceArrival` is the time in seconds since this frame arrived,
  /// `sinceFirst` the time since the first frame of the run arrived.
  void countFrame(double sinceArrival, double sinceFirst);
  /// Adds the latency of the images of a live frame. `taken` is when the tracking thread took the
  /// images, `estimated` when their estimate was finished.
  void countLiveFrame(const FrameSet& frames, LatencyStages::Clock::time_point taken,
                      LatencyStages::Clock::time_point estimated);
  /// Stores which live images a tracked frame has. Only the first kMaxLiveFrameRecords frames of
  /// the run are stored. A frame that is tracked again is not stored again.
  void addLiveFrameRecord(const FrameSet& frames);
  static constexpr std::size_t kMaxLiveFrameRecords = 500000;
  /// Returns, for each frame from live cameras, which images were tracked in it, in ascending frame
  /// order.
  std::vector<LiveFrameRecord> liveFrameRecords() const;
  /// Adds the time from a live estimate until a view has painted it, in seconds.
  void addDrawingTime(double seconds);
  /// Sets whether the end of the input was reached.
  void setFinished(bool finished);
  /// Sets the notices (messages for the user) that apply to the run now. `time` is the current time
  /// of the run, seconds.
  void setNotices(const std::vector<Error>& notices, double time);
  /// Sets the number of filter threads.
  void setThreadCount(int threads);
  /// Removes the records of this frame and later ones; readers receive all records again.
  void goBack(std::int64_t frame);
  /// Changes the indices of the targets: the target that had index k gets index numbers[k], or is
  /// removed if this is -1. There are `count` targets afterward. Readers receive all records again.
  void changeTargetIndices(const std::vector<int>& numbers, std::size_t count);
  /// Returns the iteration records from `position` on, and moves `position` past them. `generation`
  /// identifies the log that the reader knows. If the log was cleared or went back since then,
  /// `generation` is updated and all records are returned. The log keeps at most
  /// kMaxIterationRecords records: when there are more, every second one of the older half is
  /// removed.
  LogUpdate<IterationRecord> iterationsSince(std::uint64_t& generation,
                                             std::size_t& position) const;
  static constexpr std::size_t kMaxFrameRecords = 50000;
  /// Returns the records of tracked frames from `position` on, and moves `position` past them.
  /// `generation` identifies the log that the reader knows; if the log was cleared or went back
  /// since then, all records are returned. The log keeps at most kMaxFrameRecords records of
  /// frames.
  LogUpdate<FrameRecord> framesSince(std::uint64_t& generation, std::size_t& position) const;
  /// Appends the record of one frame. If this frame is already the last one in the log, its former
  /// record is replaced.
  void append(const FrameRecord& record);
  /// Appends the people of one frame. If this frame is already the last one in the log, its former
  /// people are replaced. At most kMaxPeopleFrames frames are kept (about 100 MB with two people):
  /// when there are more, every second one of the older half is removed.
  void append(PeopleFramePtr people);
  static constexpr std::size_t kMaxPeopleFrames = 10000;
  std::vector<PeopleFramePtr> peopleFrames() const;
  /// Adds `change` to the header of the trajectory: a description of the settings that have changed
  /// from this frame on. Earlier descriptions for this frame and later ones are removed.
  void noteSettingsChange(std::int64_t frame, const std::string& change);
  Trajectory trajectory() const;
  /// Returns the samples added to the trajectory since the last call. `position` is the index of
  /// the first sample in the last frame that the reader knows. This frame is returned again,
  /// because it may have been replaced. `generation` identifies the log that the reader knows; if
  /// the log was cleared or went back since then, all samples are returned.
  LogUpdate<TrajectorySample> samplesSince(std::uint64_t& generation, std::size_t& position) const;
  /// Returns all bounding boxes so far; empty unless the method tracks boxes.
  BoxTrack boxTrack() const;
  /// Returns the bounding boxes added since the last call, and again those of the last frame that
  /// the reader knows, because they may have been replaced. `position` is the index of the first
  /// box in that frame. `generation` identifies the log that the reader knows; if the log was
  /// cleared or went back since then, all boxes are returned.
  LogUpdate<BoxSample> boxesSince(std::uint64_t& generation, std::size_t& position) const;
  /// Sets which of the results so far are old: they came from settings other than the current ones.
  void setOldResults(OldResults old);
  OldResults oldResults() const;
  Latency latency() const;
  LiveLatency liveLatency() const;
  /// Returns the data from which runReport() makes run.json.
  std::pair<Project, RunStatistics> runReportData() const;

private:
  void rename(const std::vector<Target>& targets); ///< from the names in project_

  mutable std::mutex mutex_;
  std::uint64_t generation_ = 1;
  ThinnedLog<IterationRecord> records_;
  ThinnedLog<FrameRecord> frames_;
  ThinnedLog<PeopleFramePtr> people_;
  Trajectory trajectory_;
  std::vector<BoxSample> boxes_;
  Project project_;
  RunStatistics statistics_;
  OldResults oldResults_;
  std::vector<LiveFrameRecord> liveFrameRecords_;
};

} // namespace dewpoint::session
