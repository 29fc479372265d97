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

/// One target in one row: lengths in the unit, and along the axes, of the table.
struct ExportCell {
  bool present = false;   ///< otherwise nothing else is set
  bool filled = false;    ///< interpolated over a gap
  bool corrected = false; ///< the user said in this frame where the target is
  bool ambiguous = false; ///< something else may be the target about as well
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  std::optional<Eigen::Matrix3d> covariance; ///< nothing: not known
  std::optional<Eigen::Vector3d> best;       ///< particle of highest weight; nothing: not known
  std::optional<Eigen::Matrix3d> extent;     ///< of what is no ball; nothing: a ball, or not known
  double effectiveSampleSize = 0.0;
  int cameras = 0;
};

/// What an export writes: a row per instant, a column per target.
struct ExportTable {
  std::vector<std::string> targets;
  std::vector<double> times;                  ///< seconds, ascending, by row
  std::vector<std::int64_t> frames;           ///< by row
  std::vector<std::vector<ExportCell>> cells; ///< [target][row]
  double rate = 0.0;                          ///< rows per second
  double recordedRate = 0.0;                  ///< the same before it was resampled
  std::size_t recordedRows = 0;               ///< with those that were dropped
  bool covariance = false;                    ///< some cell has one
  bool best = false;                          ///< some cell has one
  bool corrected = false;                     ///< some cell is
  bool ambiguous = false;                     ///< some cell is
  bool extent = false;                        ///< some cell has one
  WorldAxes axes = WorldAxes::ZUp;
  LengthUnit unit = LengthUnit::Meter;
  bool header = true;
  /// The header: version, project, method, seed, ..., smoothed, date.
  std::vector<std::pair<std::string, std::string>> entries;

  std::size_t rowCount() const { return times.size(); }
  /// Target and row pairs without a position.
  std::size_t gapCount() const;
  /// "m" or "mm".
  const char* unitName() const { return unit == LengthUnit::Meter ? "m" : "mm"; }
};

/// How a format wants a table to be where the user has not chosen.
struct TableRequest {
  WorldAxes axes = WorldAxes::ZUp;
  LengthUnit unit = LengthUnit::Meter;
  bool evenRows = false; ///< rows at equal distances in time
};

/// Picks, smooths, resamples, fills and turns. Positions between recorded ones lie on the cubic
/// through them whose slopes are those of the parabola through each three neighbors (exact for a
/// ball in flight). NotFound names an unknown target; BadValue what is empty or not a number. Once
/// `progress` (0 to 1) has returned false, what is returned is of no use.
Result<ExportTable> makeExportTable(const Trajectory& trajectory, const ExportOptions& options,
                                    const TableRequest& usual,
                                    const std::function<bool(double)>& progress = {});

} // namespace dewpoint::trajectory
