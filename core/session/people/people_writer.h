// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/growing_file.h"
#include "core/tracking/tracker_capabilities.h"
#include "core/trajectory/trajectory_writer.h"

#include <cstdint>
#include <filesystem>

namespace dewpoint::session {

/// The sample that stands for a person in a trajectory.
TrajectorySample sampleOf(const PersonEstimate& person, std::int64_t frame, double time);

/// Writes what is known about people, frame by frame, into a folder:
/// - trajectory.csv: positions and identities, as every trajectory of ours (`person N` is the
/// target);
/// - volumes.csv: frame, time_s, person, volume_m3, vertices, interacting, hue, saturation,
/// height_m;
/// - hulls.csv: frame, person, vertex, x_m, y_m, z_m: corners of the convex hull of the 95 %
/// volume;
/// - ground.csv: frame, person, probability, curve, point, x_m, y_m: level curves, around the
///   smallest areas of the floor that hold 25, 50, 75 and 95 % of the occupancy density.
class PeopleWriter {
public:
  /// Makes the folder and empties the files; FileUnwritable.
  static Result<PeopleWriter> create(const std::filesystem::path& folder,
                                     const TrajectoryHeader& header);

  Status write(const PeopleFinding& people, std::int64_t frame, double time);
  /// One person at one frame.
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
