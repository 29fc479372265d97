// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/track/track_job.h"

#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/dewpoint-cli/common/progress.h"
#include "app/dewpoint-cli/track/run_notes.h"
#include "core/base/text_file.h"
#include "core/base/units.h"
#include "core/experiment/metrics/truth_names.h"
#include "core/session/run/run_report.h"
#include "core/session/run/tracking_run.h"
#include "core/session/watch/camera_agreement_watch.h"
#include "core/session/watch/camera_motion_observer.h"
#include "core/session/watch/camera_motion_watch.h"
#include "core/session/watch/state_log.h"
#include "core/trajectory/evaluation.h"
#include "core/trajectory/jobs/job_folder.h"
#include "core/trajectory/trajectory_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::app {
namespace {

// A delay is named if it is larger than this, in seconds and in standard deviations: less shifts a
// walking person by a millimeter. Judgments.
constexpr double kNotableDelay = 1e-3;
constexpr double kNotableSigmas = 3.0;

/// Where the results of a run go: a file that grows with it, or boxes that are written at its end.
struct TrackOutput {
  std::optional<TrajectoryWriter> writer; ///< not with boxes, which are in no space
  Trajectory kept;
  BoxTrack boxes;
  std::optional<StateLog> reasons = std::nullopt;
  std::optional<TrackedFrame> previous = std::nullopt; ///< while there are reasons to write

  void takeReasons(const TrackingRun& run) {
    TrackedFrame now = run.trackedFrame(0, previous ? &*previous : nullptr);
    reasons->append(frameRecord(now, *run.frames()), run.targets());
    previous = std::move(now);
  }
  Status take(const TrackingRun& run) {
    if (reasons) {
      takeReasons(run);
    }
    std::ranges::move(run.boxSamples(), std::back_inserter(boxes.samples));
    for (const auto& sample : run.samples()) {
      if (const auto written = writer->write(sample); !written) {
        return written;
      }
      kept.samples.push_back(sample);
    }
    return {};
  }
  Status finish(const std::filesystem::path& folder) {
    if (reasons) {
      if (const auto written = writeTextFile(folder / "reasons.csv", reasons->csv()); !written) {
        return written;
      }
    }
    return writer ? writer->finish() : writeBoxTrack(boxes, folder);
  }
  /// In how many frames each target was found.
  std::vector<JobTarget> targets() const {
    std::map<std::string, std::int64_t> valid;
    for (const TrajectorySample& sample : kept.samples) {
      valid[sample.target] += sample.isValid ? 1 : 0;
    }
    for (const auto& sample : boxes.samples) {
      valid[std::to_string(sample.target)] += sample.estimate.isVisible ? 1 : 0;
    }
    std::vector<JobTarget> targets;
    targets.reserve(valid.size());
    for (const auto& [name, frames] : valid) {
      targets.push_back({name, frames});
    }
    return targets;
  }
};

/// The files whose content a repetition does not change.
std::vector<std::string> resultFiles(const TrackJob& job, const TrackingRun& run,
                                     const Project& project) {
  std::vector<std::string> names{"trajectory.csv"};
  if (!run.definition()->family().writesPositions()) {
    names = {"boxes.csv", "boxes_mot.txt"};
  }
  if (!project.scene.empty()) {
    names.emplace_back("truth.csv");
  }
  if (job.writesReasonsFile) {
    names.emplace_back("reasons.csv");
  }
  return names;
}

/// Writes and says what becomes of the frames of a job.
class TrackObserver final : public FrameObserver {
public:
  TrackObserver(Progress& progress, TrackOutput& output, RunStatistics& figures)
      : progress_(progress), output_(output), figures_(figures) {}

  void onFrameTaken(const FrameSet& /*frames*/) override { taken_ = Clock::now(); }
  void onIteration(const TrackingRun& /*run*/, double microseconds) override {
    figures_.iterationDurations.add(1e-6 * microseconds);
    iterated_ = Clock::now();
  }
  Status onFrameTracked(const TrackingRun& run) override {
    const std::chrono::duration<double> took = std::max(taken_, iterated_) - taken_;
    figures_.frameDurations.add(took.count());
    if (const auto written = output_.take(run); !written) {
      return written;
    }
    progress_.show(++figures_.frameCount);
    return {};
  }

private:
  using Clock = std::chrono::steady_clock;

  Progress& progress_;
  TrackOutput& output_;
  RunStatistics& figures_;
  Clock::time_point taken_;
  Clock::time_point iterated_; ///< the last time
};

/// Tracks the frames of a job; what stopped it, if it was not the end.
Status trackJob(const TrackJob& job, FrameSetSource& source, TrackingRun& run, TrackOutput& output,
                RunStatistics& figures) {
  Progress progress("tracking", job.frames.countIn(source).value_or(0));
  RunNotes notes(source, run.rig());
  TrackObserver observer(progress, output, figures);
  const auto shouldContinue = [&] {
    notes.printNotices();
    return !wasInterruptionRequested();
  };
  const std::array<FrameObserver*, 2> observers{&notes, &observer};
  const Status tracked = trackFrames(source, job.frames, run, observers, shouldContinue);
  notes.printNotices();
  progress.finish();
  figures.notices = notes.printedNotes();
  return tracked;
}

/// The names of the targets that have the same colors, for each such colors.
std::vector<std::vector<std::string>> targetsAlike(const std::vector<Target>& targets) {
  std::vector<std::vector<std::string>> groups;
  std::vector<ColorRanges> colors;
  for (const Target& target : targets) {
    const auto found = std::ranges::find(colors, target.colors());
    if (found == colors.end()) {
      colors.push_back(target.colors());
      groups.push_back({target.name});
    } else {
      groups[static_cast<std::size_t>(found - colors.begin())].push_back(target.name);
    }
  }
  return groups;
}

/// Names the cameras whose images are clearly late or early.
void printClocks(const std::vector<ClockEstimate>& clocks, const CameraRig& rig) {
  for (std::size_t k = 1; k < clocks.size(); ++k) {
    const ClockEstimate& clock = clocks[k];
    if (std::abs(clock.delaySeconds) > std::max(kNotableDelay, kNotableSigmas * clock.delaySigma)) {
      fmt::print("images of {:<13} {:>7.1f} ms {} than those of {} (± {:.1f} ms, corrected)\n",
                 rig[k].name, inMilliseconds(std::abs(clock.delaySeconds)),
                 clock.delaySeconds > 0.0 ? "later" : "earlier", rig[0].name,
                 inMilliseconds(clock.delaySigma));
    }
  }
}

void printSummary(const Trajectory& estimate, const Trajectory& truth, const CameraRig& rig,
                  const std::vector<Target>& targets, int iterationsPerFrame,
                  const RunStatistics& figures) {
  fmt::print("frames                  {:>10}\n", figures.frameCount);
  fmt::print("frames per second       {:>10.1f}\n",
             static_cast<double>(figures.frameCount) / std::max(1e-9, figures.durationSeconds));
  fmt::print("us per iteration p50    {:>10.1f}\n", 1e6 * figures.iterationDurations.quantile(0.5));
  fmt::print("us per iteration p99    {:>10.1f}\n",
             1e6 * figures.iterationDurations.quantile(0.99));
  printClocks(figures.clockEstimates, rig);
  if (truth.samples.empty()) {
    return;
  }
  const auto truthNames = truthNamesByPosition(estimate, truth, targetsAlike(targets));
  const auto evaluations = evaluate(estimate, withTrackedNames(truth, truthNames));
  for (std::size_t k = 0; evaluations && k < evaluations->size(); ++k) {
    const auto& one = (*evaluations)[k];
    fmt::print("target                  {:>10}\n", one.target);
    if (const auto other = truthNames.find(one.target); other != truthNames.end()) {
      fmt::print("compared with           {:>10}, by position: they have the same color\n",
                 other->second);
    }
    if (one.convergenceFrameCount) {
      fmt::print("iterations to converge  {:>10}\n",
                 (*one.convergenceFrameCount + 1) * iterationsPerFrame);
      fmt::print("error RMSE              {:>7.1f} mm\n", inMillimeters(one.rmse));
      fmt::print("error p95               {:>7.1f} mm\n", inMillimeters(one.p95));
      fmt::print("frames lost             {:>10}\n", one.lostFrameCount);
    } else {
      fmt::print("iterations to converge  {:>10}\n", "never");
      fmt::print("error RMSE, all frames  {:>7.1f} mm\n", inMillimeters(one.rmseOfAllFrames));
    }
  }
}

} // namespace

int TrackJob::run(SessionInputs inputs) const {
  auto run = TrackingRun::create(inputs.project, threadCount, inputs.backgroundImages);
  if (!run) {
    return reportError(run.error());
  }
  // The parameters in use stand in all that is written.
  inputs.project = run->definition()->appliedTo(std::move(inputs.project));
  const std::vector<std::string> results = resultFiles(*this, *run, inputs.project);
  const auto begun = JobFolder::beginJob(folder, results);
  if (!begun) {
    return reportError(begun.error());
  }
  const TrajectoryHeader header = trajectoryHeader(inputs.project);
  TrackOutput output{std::nullopt, {header, {}}, {boxTrackHeader(inputs.project), {}}};
  if (run->definition()->family().writesPositions()) {
    auto writer = TrajectoryWriter::create(folder / "trajectory.csv", header);
    if (!writer) {
      return reportError(writer.error());
    }
    output.writer.emplace(std::move(*writer));
  }
  if (writesReasonsFile) {
    output.reasons.emplace(rigOf(inputs.project));
  }
  catchInterruption();

  // Before the run, so that one that is killed can be compared too.
  if (!inputs.project.scene.empty()) {
    if (const auto written = writeTrajectory(inputs.truth, folder / "truth.csv"); !written) {
      return reportError(written.error());
    }
  }
  RunStatistics figures;
  // Written now too: after a kill it says that the run did not finish.
  figures.threadCount = threadCount;
  const auto reported = writeTextFile(folder / "run.json", runReport(inputs.project, figures));
  if (!reported) {
    return reportError(reported.error());
  }
  const auto begin = std::chrono::steady_clock::now();
  auto tracked = trackJob(*this, *inputs.source, *run, output, figures);
  if (const auto finished = output.finish(folder); !finished && tracked) {
    tracked = finished;
  }
  figures.durationSeconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  figures.isFinished = tracked.has_value() && !wasInterruptionRequested();
  if (!tracked) {
    figures.notices.push_back(errorSentence(tracked.error()));
  }
  figures.droppedFrameCount = inputs.source->droppedFrameCount();
  figures.clockEstimates = run->clockEstimates();
  const auto ended = writeTextFile(folder / "run.json", runReport(inputs.project, figures));
  printSummary(output.kept, inputs.truth, run->rig(), inputs.project.targets,
               run->iterationsPerFrame(), figures);
  if (!tracked) {
    // Frames were tracked before the input broke: that is "ended early", whatever broke it.
    const int code = reportError(tracked.error());
    return code == kExitBadInput && figures.frameCount > 0 ? kExitEndedEarly : code;
  }
  if (!ended) {
    return reportError(ended.error());
  }
  if (!figures.isFinished) {
    return kExitInterrupted;
  }
  JobRecord done = record;
  done.frameCount = figures.frameCount;
  done.trackingSeconds = figures.durationSeconds;
  done.threadCount = threadCount;
  done.targets = output.targets();
  const auto finished = begun->finish(std::move(done), results);
  return finished ? kExitDone : reportError(finished.error());
}

} // namespace dewpoint::app
