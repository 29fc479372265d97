// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/session/frames/tracked_frame.h"
#include "core/tracking/people_state.h"
#include "core/tracking/track_estimate.h"
#include "core/trajectory/trajectory.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

namespace dewpoint::session {

/// People in one frame, with the weighted points from which the volumes of their bodies are
/// computed.
struct PeopleFrame {
  struct Person {
    PersonEstimate estimate;
    Eigen::ArrayXXf points; ///< one row per point: x, y, z in meters
    Eigen::ArrayXf weights; ///< weights of the points, linear
    BodyCloud bodyCloud() const { return {points.cast<double>(), weights.cast<double>()}; }
  };
  std::int64_t frame = 0;
  double time = 0.0; ///< time of the frame, seconds
  std::vector<Person> people;
};
using PeopleFramePtr = std::shared_ptr<const PeopleFrame>;

/// Returns the people of a tracked frame.
PeopleFramePtr peopleFrame(const TrackedFrame& trackedFrame);

/// All data about the people of a run. This is an independent copy, so any thread can write it to
/// files while the run continues.
struct PeopleRecord {
  Trajectory trajectory;
  std::vector<PeopleFramePtr> frames;
};
/// Writes trajectory.csv, volumes.csv, hulls.csv and ground.csv to a folder (see PeopleWriter), and
/// returns the number of frames written. This takes a few milliseconds per person and frame.
/// `shouldContinue` receives the progress (0 to 1); if it returns false, the remaining frames are
/// omitted. Returns FileUnwritable if a file cannot be written.
Result<std::size_t> savePeople(const PeopleRecord& record, const std::filesystem::path& folder,
                               const std::function<bool(double)>& shouldContinue);

} // namespace dewpoint::session
