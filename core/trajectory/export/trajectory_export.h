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

/// Called from time to time with the progress, 0 to 1; returning false cancels the export.
using ExportProgress = std::function<bool(double)>;

/// Outcome of an export.
struct ExportSummary {
  std::vector<std::filesystem::path> files; ///< files written, the main one last
  std::size_t rows = 0;
  std::size_t targets = 0;
  std::size_t gaps = 0; ///< target and row pairs left empty
  bool canceled = false;
  std::filesystem::path occupied; ///< is there already and may not be replaced: nothing was written
};

/// Preview of an export.
struct ExportPreview {
  std::string units; ///< units and axes in one sentence
  std::string size;  ///< targets, rows, rate and gaps in one sentence
  std::string text;  ///< first lines of a text file, or a description of a binary one
  // The same as values, for messages in other languages.
  WorldAxes axes = WorldAxes::ZUp;
  LengthUnit unit = LengthUnit::Meter;
  std::size_t targets = 0;
  std::size_t rows = 0;
  std::size_t gaps = 0;
  double rate = 0.0; ///< rows per second
};

/// Writes the trajectory as `options.format` to `file` (formats of several files put the others
/// beside it). The file is written beside, flushed and renamed, as the last one. A canceled or
/// failed export takes the files away again that it has made. FileUnwritable, and the errors of
/// makeExportTable() and of the format.
Result<ExportSummary> exportTrajectory(const Trajectory& trajectory, const ExportOptions& options,
                                       const std::filesystem::path& file,
                                       const ExportProgress& progress = {});

/// The first `lineCount` lines as exportTrajectory() would write them. Canceled when `progress`
/// says so.
Result<ExportPreview> previewExport(const Trajectory& trajectory, const ExportOptions& options,
                                    const std::filesystem::path& file, std::size_t lineCount = 40,
                                    const ExportProgress& progress = {});

/// Reads the trajectory of an export from a trajectory file or from the folder of a run.
Result<Trajectory> readExportSource(const std::filesystem::path& fileOrFolder);

} // namespace dewpoint::trajectory
