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

/// The people of one frame with their bodies: what their volumes are written from.
struct PeopleFrame {
  struct Person {
    PersonEstimate estimate;
    Eigen::ArrayXXf points; ///< rows x y z, meters
    Eigen::ArrayXf weights; ///< one per row, linear
    BodyCloud body() const { return {points.cast<double>(), weights.cast<double>()}; }
  };
  std::int64_t frame = 0;
  double time = 0.0; ///< seconds
  std::vector<Person> people;
};
using PeopleFramePtr = std::shared_ptr<const PeopleFrame>;

PeopleFramePtr peopleFrame(const TrackedFrame& trackedFrame);

/// All that is known of the people of a run; a value of its own, to be written beside it.
struct PeopleRecord {
  Trajectory trajectory;
  std::vector<PeopleFramePtr> frames;
};
/// Writes trajectory.csv, volumes.csv, hulls.csv and ground.csv into a folder (PeopleWriter): some
/// milliseconds per person and frame. `goOn` receives the part done (0 to 1); at its false the rest
/// is left out. How many frames were written; FileUnwritable.
Result<std::size_t> savePeople(const PeopleRecord& record, const std::filesystem::path& folder,
                               const std::function<bool(double)>& goOn);

} // namespace dewpoint::session
