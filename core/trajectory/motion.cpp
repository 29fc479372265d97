// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/motion.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::trajectory {
namespace {

constexpr std::size_t kReach = 2; ///< samples on each side that a speed is of

bool isSame(const TrajectorySample& a, const TrajectorySample& b) {
  return a.frame == b.frame && a.target == b.target && a.time == b.time && a.isValid == b.isValid &&
         a.position == b.position && a.covariance == b.covariance;
}

bool isUsable(const TrajectorySample& sample) {
  return sample.isValid && sample.position.allFinite();
}

} // namespace

double positionSigma(const TrajectorySample& sample, int axis) {
  return std::sqrt(std::max(0.0, sample.covariance(axis, axis)));
}

std::optional<Eigen::Vector3d> velocityAt(std::span<const TrajectorySample> track,
                                          std::size_t index, std::size_t reach) {
  if (!isUsable(track[index])) {
    return std::nullopt;
  }
  std::size_t first = index;
  std::size_t last = index;
  const auto follows = [&](std::size_t before) {
    return isUsable(track[before]) && isUsable(track[before + 1]) &&
           track[before + 1].frame <= track[before].frame + 1;
  };
  while (first > 0 && index - first < reach && follows(first - 1)) {
    --first;
  }
  while (last + 1 < track.size() && last - index < reach && follows(last)) {
    ++last;
  }
  const auto count = static_cast<double>(last - first + 1);
  double meanTime = 0.0;
  Eigen::Vector3d meanPosition = Eigen::Vector3d::Zero();
  for (std::size_t i = first; i <= last; ++i) {
    meanTime += track[i].time / count;
    meanPosition += track[i].position / count;
  }
  double spread = 0.0;
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
  for (std::size_t i = first; i <= last; ++i) {
    const double apart = track[i].time - meanTime;
    spread += apart * apart;
    slope += apart * (track[i].position - meanPosition);
  }
  if (!(spread > 0.0)) {
    return std::nullopt; // alone, or without times
  }
  return slope / spread;
}

void MotionLog::clear() {
  rows_.clear();
  tracks_.clear();
  dropped_ = 0;
}

MotionLog::Change MotionLog::replaceFrom(std::size_t first,
                                         const std::vector<TrajectorySample>& samples) {
  if (first == 0 && dropped_ > 0) {
    clear(); // all from the start again: not a part of what is known
  }
  std::size_t skipped = first < dropped_ ? std::min(dropped_ - first, samples.size()) : 0;
  std::size_t rowIndex = std::max(first, dropped_) - dropped_;
  while (skipped < samples.size() && rowIndex < rows_.size() &&
         isSame(rows_[rowIndex].sample, samples[skipped])) {
    ++skipped;
    ++rowIndex;
  }
  if (rowIndex < rows_.size()) {
    truncate(rowIndex);
  }
  Change change{0, rows_.size()};
  for (; skipped < samples.size(); ++skipped) {
    append(samples[skipped]);
    updateSpeeds(tracks_[samples[skipped].target], change.firstChangedRow);
  }
  if (rows_.size() > kMaxRows) {
    change.droppedRowCount = dropOldRows();
    change.firstChangedRow -= std::min(change.firstChangedRow, change.droppedRowCount);
  }
  return change;
}

void MotionLog::append(const TrajectorySample& sample) {
  Track& track = tracks_[sample.target];
  const bool known = !track.rowIndices.empty() && track.rowIndices.back() >= dropped_;
  extendGaps(track, known ? &rows_[track.rowIndices.back() - dropped_].sample : nullptr, sample);
  track.rowIndices.push_back(dropped_ + rows_.size());
  rows_.push_back({sample});
}

void MotionLog::extendGaps(Track& track, const TrajectorySample* before,
                           const TrajectorySample& sample) {
  const bool missing = before != nullptr && sample.frame > before->frame + 1;
  if (!track.isGapOpen && (missing || !isUsable(sample))) {
    const std::int64_t first = missing ? before->frame + 1 : sample.frame;
    const double from = before != nullptr ? before->time : sample.time;
    track.gaps.push_back({sample.target, first, first, from, from});
    track.isGapOpen = true;
  }
  if (track.isGapOpen) {
    TrajectoryGap& gap = track.gaps.back();
    track.isGapOpen = !isUsable(sample);
    gap.lastFrame = track.isGapOpen ? sample.frame : sample.frame - 1;
    gap.endTime = sample.time;
  }
}

/// A new sample changes the speeds of those before it that it is a neighbor of.
void MotionLog::updateSpeeds(const Track& track, std::size_t& firstChangedRow) {
  const std::size_t wanted = std::min(track.rowIndices.size(), 2 * kReach + 1);
  std::vector<TrajectorySample> end;
  std::vector<std::size_t> rowIndices;
  for (std::size_t i = track.rowIndices.size() - wanted; i < track.rowIndices.size(); ++i) {
    if (track.rowIndices[i] >= dropped_) {
      rowIndices.push_back(track.rowIndices[i] - dropped_);
      end.push_back(rows_[rowIndices.back()].sample);
    }
  }
  for (std::size_t i = end.size() - std::min(end.size(), kReach + 1); i < end.size(); ++i) {
    const auto velocity = velocityAt(end, i, kReach);
    const double speed = velocity ? velocity->norm() : std::numeric_limits<double>::quiet_NaN();
    Row& row = rows_[rowIndices[i]];
    if (speed != row.speed && !(speed != speed && row.speed != row.speed)) {
      row.speed = speed;
      firstChangedRow = std::min(firstChangedRow, rowIndices[i]);
    }
  }
}

void MotionLog::truncate(std::size_t size) {
  // Rare: the same frame again, or a run that went back.
  std::vector<Row> kept(rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(size));
  rows_.clear();
  tracks_.clear();
  for (Row& row : kept) {
    append(row.sample);
    rows_.back().speed = row.speed;
  }
  std::size_t changed = rows_.size();
  for (const auto& [name, track] : tracks_) {
    updateSpeeds(track, changed);
  }
}

std::size_t MotionLog::dropOldRows() {
  const std::size_t surplus = rows_.size() / 2;
  rows_.erase(rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(surplus));
  dropped_ += surplus;
  for (auto& [name, track] : tracks_) {
    std::erase_if(track.rowIndices, [this](std::size_t row) { return row < dropped_; });
  }
  return surplus;
}

std::vector<TrajectoryGap> MotionLog::gaps() const {
  std::vector<TrajectoryGap> all;
  for (const auto& [name, track] : tracks_) {
    all.insert(all.end(), track.gaps.begin(), track.gaps.end());
  }
  std::ranges::stable_sort(all, {}, &TrajectoryGap::firstFrame);
  return all;
}

} // namespace dewpoint::trajectory
