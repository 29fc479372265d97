// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/growing_file.h"
#include "core/tracking/tracker_capabilities.h"
#include "core/trajectory/trajectory_writer.h"

#include <cstdint>
#include <filesystem>

namespace dewpoint::session {

/// Returns the estimate of a person as a row of a trajectory; `time` in seconds.
TrajectorySample sampleOf(const PersonEstimate& person, std::int64_t frame, double time);

/// Writes the results of people tracking, frame by frame, to a folder:
/// - trajectory.csv: positions and identities, in the usual trajectory format (the target is called
///   `person N`);
/// - volumes.csv: frame, time_s, person, volume_m3, vertices, interacting, hue, saturation,
///   height_m;
/// - hulls.csv: frame, person, vertex, x_m, y_m, z_m: corners of the convex hull of the 95 %
///   volume;
/// - ground.csv: frame, person, probability, curve, point, x_m, y_m: level curves around the
///   smallest areas of the floor that contain 25, 50, 75 and 95 % of the occupancy density.
class PeopleWriter {
public:
  /// Creates the folder and its files, and empties existing files. Returns FileUnwritable if this
  /// fails.
  static Result<PeopleWriter> create(const std::filesystem::path& folder,
                                     const TrajectoryHeader& header);

  Status write(const PeopleFinding& people, std::int64_t frame, double time);
  /// Writes one person in one frame.
  Status writePerson(const PersonEstimate& person, const BodyCloud& body, std::int64_t frame,
                     double time);
  Status finish();

private:
  PeopleWriter(TrajectoryWriter trajectory, GrowingFile volumes, GrowingFile hulls,
               GrowingFile ground);

  TrajectoryWriter trajectory_;
  GrowingFile volumes_;
  GrowingFile hulls_;
  GrowingFile ground_;
};

} // namespace dewpoint::session
