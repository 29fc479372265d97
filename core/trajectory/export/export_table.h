// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/export/export_options.h"
#include "core/trajectory/trajectory.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::trajectory {

/// One target in one row. Lengths are in the unit and along the axes of the table.
struct ExportCell {
  /// False: the target has no position in this row, and no other field is set.
  bool hasPosition = false;
  bool isFilled = false;    ///< true if the position was interpolated over a gap
  bool isCorrected = false; ///< the user corrected the position in this frame
  bool isAmbiguous = false; ///< another object is about as likely to be the target
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  std::optional<Eigen::Matrix3d> covariance;   ///< covariance of the position; empty: not known
  std::optional<Eigen::Vector3d> bestParticle; ///< particle of highest weight; empty: not known
  /// Extent of a target that is not a ball, see TrajectorySample::extent. Empty if the target is a
  /// ball or the extent is not known.
  std::optional<Eigen::Matrix3d> extent;
  double effectiveSampleSize = 0.0;
  int cameraCount = 0; ///< number of cameras that show the target
};

/// Contents of an export: one row per time, one column per target.
struct ExportTable {
  std::vector<std::string> targets;
  std::vector<double> times;                  ///< time of each row, seconds, ascending
  std::vector<std::int64_t> frames;           ///< frame number of each row
  std::vector<std::vector<ExportCell>> cells; ///< cells, indexed by [target][row]
  double rowsPerSecond = 0.0;
  double recordedRowsPerSecond = 0.0; ///< rows per second before resampling
  /// Number of rows before resampling, including rows of dropped frames.
  std::size_t recordedRowCount = 0;
  bool hasCovariance = false;     ///< at least one cell has a covariance
  bool hasBestParticles = false;  ///< at least one cell has a `bestParticle`
  bool hasCorrectedCells = false; ///< at least one cell is corrected
  bool hasAmbiguousCells = false; ///< at least one cell is ambiguous
  bool hasExtent = false;         ///< at least one cell has an extent
  WorldAxes axes = WorldAxes::ZUp;
  LengthUnit unit = LengthUnit::Meter;
  bool writesHeader = true; ///< true to write metadata even if the format does not require it
  /// Entries of the header: version, project, method, seed, ..., smoothed, date.
  std::vector<std::pair<std::string, std::string>> headerEntries;

  std::size_t rowCount() const { return times.size(); }
  /// Returns the number of cells without a position.
  std::size_t gapCount() const;
  /// Returns "m" or "mm".
  const char* unitName() const { return unit == LengthUnit::Meter ? "m" : "mm"; }
};

/// Values that an export format uses for options that the user has not set, and whether the format
/// requires rows at equal time intervals.
struct TableDefaults {
  WorldAxes axes = WorldAxes::ZUp;
  LengthUnit unit = LengthUnit::Meter;
  bool requiresEvenlySpacedRows = false; ///< the format requires rows at equal time intervals
};

/// Creates the table for an export: selects targets and rows, smooths, resamples, fills gaps and
/// rotates to the axes of the file. Positions between recorded positions are computed by
/// interpolatedPosition() (path_interpolation.h), which is exact for a ball in free flight. Returns
/// NotFound with the name of an unknown target, or BadValue with the name of an empty or invalid
/// option. If `progress` (called with 0 to 1) has returned false, the result is not usable.
Result<ExportTable> makeExportTable(const Trajectory& trajectory, const ExportOptions& options,
                                    const TableDefaults& defaults,
                                    const std::function<bool(double)>& progress = {});

} // namespace dewpoint::trajectory
