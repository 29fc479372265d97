// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/export/export_formats.h"
#include "core/trajectory/export/export_options.h"
#include "core/trajectory/trajectory.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace dewpoint::trajectory {

/// Called now and then with how much is done, 0 to 1; false ends the export.
using ExportProgress = std::function<bool(double)>;

struct ExportSummary {
  std::vector<std::filesystem::path> files; ///< written, the main one last
  std::size_t rows = 0;
  std::size_t targets = 0;
  std::size_t gaps = 0; ///< target and row pairs left empty
  bool cancelled = false;
  std::filesystem::path occupied; ///< is there already and may not be replaced: nothing was written
};

/// What an export would write.
struct ExportPreview {
  std::string units; ///< units and axes, one sentence
  std::string size;  ///< targets, rows, rate, gaps, one sentence
  std::string text;  ///< the first lines, or what the bytes hold
  // The same as values, for messages in another language.
  WorldAxes axes = WorldAxes::ZUp;
  LengthUnit unit = LengthUnit::Meter;
  std::size_t targets = 0;
  std::size_t rows = 0;
  std::size_t gaps = 0;
  double rate = 0.0; ///< rows per second
};

/// Writes the trajectory as `options.format` to `file` (formats of several files put the others
/// beside it). The file is written beside, flushed and renamed, as the last one. A cancelled or
/// failed export takes the files away again that it has made. FileUnwritable, and the errors of
/// makeExportTable() and of the format.
Result<ExportSummary> exportTrajectory(const Trajectory& trajectory, const ExportOptions& options,
                                       const std::filesystem::path& file,
                                       const ExportProgress& progress = {});

/// The first `lineCount` lines as exportTrajectory() would write them. Cancelled when `progress`
/// says so.
Result<ExportPreview> previewExport(const Trajectory& trajectory, const ExportOptions& options,
                                    const std::filesystem::path& file, std::size_t lineCount = 40,
                                    const ExportProgress& progress = {});

/// Reads the trajectory of an export's source: a trajectory file, or a run's folder with one.
Result<Trajectory> readExportSource(const std::filesystem::path& fileOrFolder);

} // namespace dewpoint::trajectory
