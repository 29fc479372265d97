// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/log/run_log.h"

#include "core/session/run/tracking_run.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace dewpoint::session {
namespace {

/// Key in the trajectory's header, before the number of the frame.
constexpr std::string_view kChangedAt = "changed_at_frame_";

/// Makes a reader of another generation begin again; whether it does.
bool resetReaderIfStale(std::uint64_t own, std::uint64_t& generation, std::size_t& position) {
  if (generation == own) {
    return false;
  }
  generation = own;
  position = 0;
  return true;
}

/// Appends samples of one frame in place of those of the same frame.
template <class Sample>
void appendFrame(std::vector<Sample>& all, const std::vector<Sample>& samples) {
  while (!samples.empty() && !all.empty() && all.back().frame == samples.front().frame) {
    all.pop_back();
  }
  all.insert(all.end(), samples.begin(), samples.end());
}

/// What `all` gained since `position`, which moves to where the last frame begins.
template <class Sample>
void takeSince(const std::vector<Sample>& all, std::size_t& position, LogUpdate<Sample>& piece) {
  piece.first = std::min(position, all.size());
  piece.records.assign(all.begin() + static_cast<std::ptrdiff_t>(piece.first), all.end());
  position = all.size();
  while (position > 0 && all[position - 1].frame == all.back().frame) {
    --position;
  }
}

} // namespace

RunLog::RunLog()
    : records_(kMaxIterationRecords,
               [](const IterationRecord& record) { return record.iteration; }),
      frames_(kMaxFrameRecords, [](const FrameRecord& record) { return record.frame; }),
      people_(kMaxPeopleFrames, [](const PeopleFramePtr& people) { return people->frame; }) {}

void RunLog::restart(const Project& project, int threads) {
  const std::lock_guard lock(mutex_);
  ++generation_;
  records_.clear();
  frames_.clear();
  people_.clear();
  trajectory_ = Trajectory{trajectoryHeader(project), {}};
  boxes_.clear();
  liveFrameRecords_.clear();
  project_ = project;
  statistics_ = RunStatistics{};
  statistics_.threadCount = threads;
}

void RunLog::setThreadCount(int threads) {
  const std::lock_guard lock(mutex_);
  statistics_.threadCount = threads;
}

void RunLog::updateProject(const Project& project) {
  const std::lock_guard lock(mutex_);
  rename(project.targets);
  project_ = project;
  TrajectoryHeader header = trajectoryHeader(project);
  if (frames_.empty()) {
    trajectory_.header = std::move(header);
  } else {
    trajectory_.header.hasCorrectedColumn = header.hasCorrectedColumn;
  }
}

void RunLog::rename(const std::vector<Target>& targets) {
  std::map<std::string, std::string, std::less<>> names;
  for (std::size_t k = 0; k < std::min(targets.size(), project_.targets.size()); ++k) {
    Target earlier = project_.targets[k];
    const std::string name = std::exchange(earlier.name, targets[k].name);
    if (name != targets[k].name && earlier == targets[k]) { // else it is another target
      names.emplace(name, targets[k].name);
    }
  }
  if (names.empty()) {
    return;
  }
  ++generation_;
  for (TrajectorySample& sample : trajectory_.samples) {
    if (const auto known = names.find(sample.target); known != names.end()) {
      sample.target = known->second;
    }
  }
}

void RunLog::setOldResults(OldResults old) {
  const std::lock_guard lock(mutex_);
  oldResults_ = std::move(old);
}

OldResults RunLog::oldResults() const {
  const std::lock_guard lock(mutex_);
  return oldResults_;
}

void RunLog::countIteration(double seconds) {
  const std::lock_guard lock(mutex_);
  statistics_.iterationDurations.add(seconds);
}

void RunLog::countFrame(double sinceArrival, double sinceFirst) {
  const std::lock_guard lock(mutex_);
  ++statistics_.frameCount;
  statistics_.frameDurations.add(sinceArrival);
  statistics_.durationSeconds = sinceFirst;
}

void RunLog::countLiveFrame(const FrameSet& frames, LatencyStages::Clock::time_point taken,
                            LatencyStages::Clock::time_point estimated) {
  const std::lock_guard lock(mutex_);
  statistics_.liveLatency.addFrames(frames, taken, estimated);
}

void RunLog::addLiveFrameRecord(const FrameSet& frames) {
  LiveFrameRecord set{frames.index, frames.time, {}};
  for (const FramePtr& frame : frames.frames) {
    set.images.push_back(
        frame ? std::optional(LiveFrameRecord::Image{frame->instants.imageId, frame->captureTime})
              : std::nullopt);
  }
  const std::lock_guard lock(mutex_);
  const bool isNew = liveFrameRecords_.empty() || liveFrameRecords_.back().index < frames.index;
  if (isNew && liveFrameRecords_.size() < kMaxLiveFrameRecords) {
    liveFrameRecords_.push_back(std::move(set));
  }
}

std::vector<LiveFrameRecord> RunLog::liveFrameRecords() const {
  const std::lock_guard lock(mutex_);
  return liveFrameRecords_;
}

void RunLog::addDrawingTime(double seconds) {
  const std::lock_guard lock(mutex_);
  statistics_.liveLatency.addDrawingTime(seconds);
}

void RunLog::setFinished(bool finished) {
  const std::lock_guard lock(mutex_);
  statistics_.isFinished = finished;
}

void RunLog::setNotices(const std::vector<Error>& notices, double time) {
  const std::lock_guard lock(mutex_);
  statistics_.noticeLog.update(notices, time);
}

void RunLog::append(const std::vector<IterationRecord>& records) {
  const std::lock_guard lock(mutex_);
  for (const IterationRecord& record : records) {
    records_.append(record);
  }
}

void RunLog::append(const FrameRecord& record) {
  const std::lock_guard lock(mutex_);
  frames_.removeLastWhile([&](const FrameRecord& last) { return last.frame == record.frame; });
  frames_.append(record);
}

void RunLog::append(PeopleFramePtr people) {
  const std::lock_guard lock(mutex_);
  people_.removeLastWhile([&](const PeopleFramePtr& last) { return last->frame == people->frame; });
  people_.append(std::move(people));
}

std::vector<PeopleFramePtr> RunLog::peopleFrames() const {
  const std::lock_guard lock(mutex_);
  std::size_t first = 0;
  return people_.since(first);
}

void RunLog::noteSettingsChange(std::int64_t frame, const std::string& change) {
  const std::lock_guard lock(mutex_);
  auto& entries = trajectory_.header.entries;
  const auto isVoid = [frame](const auto& entry) {
    return entry.first.starts_with(kChangedAt) &&
           std::stoll(entry.first.substr(kChangedAt.size())) >= frame;
  };
  std::erase_if(entries, isVoid);
  if (!change.empty()) {
    entries.emplace_back(std::string(kChangedAt) + std::to_string(frame), change);
  }
}

void RunLog::goBack(std::int64_t frame) {
  const std::lock_guard lock(mutex_);
  ++generation_;
  const auto isLater = [&](const auto& what) { return what.frame >= frame; };
  records_.removeLastWhile(isLater);
  frames_.removeLastWhile(isLater);
  people_.removeLastWhile([&](const PeopleFramePtr& people) { return isLater(*people); });
  while (!trajectory_.samples.empty() && isLater(trajectory_.samples.back())) {
    trajectory_.samples.pop_back();
  }
  while (!boxes_.empty() && isLater(boxes_.back())) {
    boxes_.pop_back();
  }
}

void RunLog::changeTargetIndices(const std::vector<int>& numbers, std::size_t count) {
  const std::lock_guard lock(mutex_);
  ++generation_;
  const auto numberOf = [&](int target) {
    const auto k = static_cast<std::size_t>(target);
    return k < numbers.size() ? numbers[k] : -1;
  };
  records_.changeOrRemoveEach([&](IterationRecord& record) {
    record.target = numberOf(record.target);
    return record.target >= 0;
  });
  frames_.changeOrRemoveEach([&](FrameRecord& record) {
    std::vector<FrameRecord::Entry> entries(count, {TargetStatus::Gone, 0.0F, {}});
    for (std::size_t k = 0; k < record.targets.size(); ++k) {
      if (const int number = numberOf(static_cast<int>(k)); number >= 0) {
        entries[static_cast<std::size_t>(number)] = std::move(record.targets[k]);
      }
    }
    record.targets = std::move(entries);
    return true;
  });
  std::erase_if(boxes_, [&](BoxSample& sample) {
    sample.target = numberOf(sample.target - 1) + 1; // they count from 1
    return sample.target == 0;
  });
  std::ranges::stable_sort(
      boxes_, {}, [](const BoxSample& sample) { return std::pair(sample.frame, sample.target); });
}

void RunLog::append(const std::vector<TrajectorySample>& samples) {
  const std::lock_guard lock(mutex_);
  appendFrame(trajectory_.samples, samples);
}

void RunLog::append(const std::vector<BoxSample>& samples) {
  const std::lock_guard lock(mutex_);
  appendFrame(boxes_, samples);
}

LogUpdate<IterationRecord> RunLog::iterationsSince(std::uint64_t& generation,
                                                   std::size_t& position) const {
  const std::lock_guard lock(mutex_);
  LogUpdate<IterationRecord> piece;
  piece.restarted = resetReaderIfStale(generation_, generation, position);
  piece.records = records_.since(position);
  return piece;
}

LogUpdate<FrameRecord> RunLog::framesSince(std::uint64_t& generation, std::size_t& position) const {
  const std::lock_guard lock(mutex_);
  LogUpdate<FrameRecord> piece;
  piece.restarted = resetReaderIfStale(generation_, generation, position);
  piece.records = frames_.since(position);
  return piece;
}

LogUpdate<TrajectorySample> RunLog::samplesSince(std::uint64_t& generation,
                                                 std::size_t& position) const {
  const std::lock_guard lock(mutex_);
  LogUpdate<TrajectorySample> piece;
  piece.restarted = resetReaderIfStale(generation_, generation, position);
  takeSince(trajectory_.samples, position, piece);
  return piece;
}

LogUpdate<BoxSample> RunLog::boxesSince(std::uint64_t& generation, std::size_t& position) const {
  const std::lock_guard lock(mutex_);
  LogUpdate<BoxSample> piece;
  piece.restarted = resetReaderIfStale(generation_, generation, position);
  takeSince(boxes_, position, piece);
  return piece;
}

BoxTrack RunLog::boxTrack() const {
  const std::lock_guard lock(mutex_);
  BoxTrack track{boxTrackHeader(project_), boxes_};
  for (const auto& entry : trajectory_.header.entries) {
    if (entry.first.starts_with(kChangedAt)) {
      track.header.push_back(entry);
    }
  }
  return track;
}

Trajectory RunLog::trajectory() const {
  const std::lock_guard lock(mutex_);
  return trajectory_;
}

Latency RunLog::latency() const {
  const std::lock_guard lock(mutex_);
  return latencyOf(statistics_.frameDurations);
}

LiveLatency RunLog::liveLatency() const {
  const std::lock_guard lock(mutex_);
  return statistics_.liveLatency.summary();
}

std::pair<Project, RunStatistics> RunLog::runReportData() const {
  const std::lock_guard lock(mutex_);
  return {project_, statistics_};
}

} // namespace dewpoint::session
