// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/people/people_frame.h"
#include "core/session/run/box_track_file.h"
#include "core/session/run/result_settings.h"
#include "core/session/run/run_report.h"
#include "core/session/run/snapshot.h"
#include "core/session/thinned_log.h"
#include "core/trajectory/trajectory.h"

#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::session {

/// What happened since the (re)start, written by the tracking thread and copied out by others.
class RunLog {
public:
  struct Piece {
    std::vector<IterationRecord> records;
    bool restarted = false; ///< all that is known comes again: a new run, or one that went back
  };
  /// About 40 MB with four cameras.
  static constexpr std::size_t kMostRecords = 100000;
  RunLog();
  /// Forgets the run; what follows belongs to this project, as it is now, and is filtered by so
  /// many threads.
  void restart(const Project& project, int threads = 1);
  /// The project has other parameters, or corrections, from now on. If nothing is recorded yet, all
  /// of the run is of this project, and so is the header of its trajectory.
  void change(const Project& project);
  void append(const std::vector<IterationRecord>& records);
  /// Samples of one frame; they replace those of the same frame, if it was the last one.
  void append(const std::vector<TrajectorySample>& samples);
  /// As samples, of boxes.
  void append(const std::vector<BoxSample>& samples);
  /// One more filter iteration, in seconds per target.
  void countIteration(double seconds);
  /// One more frame is done: seconds since it arrived, and since the run's first one did.
  void countFrame(double sinceArrival, double sinceFirst);
  /// The input's end was reached, or is ahead again.
  void setFinished(bool finished);
  /// The number of threads that share the filter's work from now on.
  void setThreads(int threads);
  /// Forgets what was recorded of this frame and of later ones; readers get all records again.
  void goBack(std::int64_t frame);
  /// Targets have other numbers: numbers[k] is that of what was k, -1 where it is gone, of `count`.
  /// Readers get all records again.
  void renumber(const std::vector<int>& numbers, std::size_t count);
  /// Records from `position` on; both arguments move along. Beyond kMostRecords the older ones are
  /// there in coarser and coarser steps.
  Piece since(std::uint64_t& generation, std::size_t& position) const;
  /// As since(), of the frames tracked: beyond kMostFrames older ones in coarser steps.
  struct FramePiece {
    std::vector<FrameRecord> records;
    bool restarted = false;
  };
  static constexpr std::size_t kMostFrames = 50000;
  FramePiece framesSince(std::uint64_t& generation, std::size_t& position) const;
  /// Adds one frame, or replaces the same frame if it was the last one.
  void append(const FrameRecord& record);
  /// Adds the people of one frame, or replaces those of the same frame if it was the last one.
  /// Beyond kMostPeopleFrames (about 100 MB with two people) older ones are kept in coarser steps.
  void append(PeopleFramePtr people);
  static constexpr std::size_t kMostPeopleFrames = 10000;
  std::vector<PeopleFramePtr> people() const;
  /// From this frame on the run is another one than the header says.
  void note(std::int64_t frame, const std::string& change);
  Trajectory trajectory() const;
  /// What the trajectory gained. `position` is where the last frame known to the reader begins: it
  /// may have been replaced, and comes again.
  struct SamplesPiece {
    std::size_t first = 0; ///< number of the first of `samples`; what was there from it on is void
    std::vector<TrajectorySample> samples;
    bool restarted = false; ///< all that is known comes again
  };
  SamplesPiece samplesSince(std::uint64_t& generation, std::size_t& position) const;
  /// The boxes so far, where boxes are followed.
  BoxTrack boxTrack() const;
  /// As samplesSince(), of the boxes.
  struct BoxesPiece {
    std::size_t first = 0;
    std::vector<BoxSample> samples;
    bool restarted = false;
  };
  BoxesPiece boxesSince(std::uint64_t& generation, std::size_t& position) const;
  /// The results so far that other settings gave than those of now.
  void setOldResults(OldResults old);
  OldResults oldResults() const;
  Latency latency() const;
  /// What run.json tells of this run.
  std::pair<Project, RunFigures> run() const;

private:
  mutable std::mutex mutex_;
  std::uint64_t generation_ = 1;
  ThinnedLog<IterationRecord> records_;
  ThinnedLog<FrameRecord> frames_;
  ThinnedLog<PeopleFramePtr> people_;
  Trajectory trajectory_;
  std::vector<BoxSample> boxes_;
  Project project_;
  RunFigures figures_;
  OldResults oldResults_;
};

} // namespace dewpoint::session
