// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trajectory/motion_series.h"

#include <array>
#include <limits>

namespace dewpoint::ui {

void MotionSeries::setTarget(const std::string& target, const std::vector<MotionLog::Row>& rows) {
  target_ = target;
  series_.reset(kColumnCount);
  update(rows, 0);
}

void MotionSeries::clear() {
  target_.clear();
  series_.reset(kColumnCount);
}

void MotionSeries::update(const std::vector<MotionLog::Row>& rows, std::size_t firstChangedRow) {
  if (firstChangedRow < rows.size()) {
    series_.removeFrom(rows[firstChangedRow].sample.frame);
    // All rows of that frame, whichever of them changed.
    while (firstChangedRow > 0 &&
           rows[firstChangedRow - 1].sample.frame == rows[firstChangedRow].sample.frame) {
      --firstChangedRow;
    }
  } else {
    series_.removeFrom(rows.empty() ? 0 : rows.back().sample.frame + 1);
  }
  for (std::size_t i = firstChangedRow; i < rows.size(); ++i) {
    const TrajectorySample& sample = rows[i].sample;
    if (sample.target == target_) {
      const float unknown = std::numeric_limits<float>::quiet_NaN();
      breakLineBefore(sample);
      const std::array<float, kColumnCount> values{
          static_cast<float>(rows[i].speed),
          sample.isValid ? static_cast<float>(sample.position.z()) : unknown};
      series_.append({sample.frame, sample.frame, sample.time}, values);
    }
  }
}

/// No line goes over frames that were never tracked.
void MotionSeries::breakLineBefore(const TrajectorySample& sample) {
  if (series_.size() == 0) {
    return;
  }
  const PlotSeries::Row last = series_.row(series_.size() - 1);
  if (isTrackInterrupted(last.frame, sample.frame)) {
    std::array<float, kColumnCount> unknown{};
    unknown.fill(std::numeric_limits<float>::quiet_NaN());
    series_.append({last.iteration + 1, last.frame + 1, last.seconds}, unknown);
  }
}

std::vector<std::vector<Eigen::Vector3d>> pathSegments(const std::vector<MotionLog::Row>& rows,
                                                       std::size_t first, std::size_t last,
                                                       const std::string& target,
                                                       std::size_t most) {
  std::vector<std::vector<Eigen::Vector3d>> strokes;
  const std::size_t step = (last - first) / (most + 1) + 1;
  bool joined = false;
  std::size_t seen = 0;
  for (std::size_t row = first; row < last; ++row) {
    const TrajectorySample& sample = rows[row].sample;
    if (sample.target != target) {
      continue;
    }
    if (!sample.isValid || !sample.position.allFinite()) {
      joined = false;
      continue;
    }
    if (!joined) {
      strokes.emplace_back();
    }
    if (!joined || seen % step == 0) {
      strokes.back().push_back(sample.position);
    }
    joined = true;
    ++seen;
  }
  return strokes;
}

} // namespace dewpoint::ui
