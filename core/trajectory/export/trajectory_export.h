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
  std::size_t rowCount = 0;
  std::size_t targetCount = 0;
  std::size_t gapCount = 0; ///< cells (one target in one row) left empty
  bool isCanceled = false;
  /// Existing file that may not be overwritten. If it is set, nothing was written; otherwise it is
  /// empty.
  std::filesystem::path existingFile;
};

/// Preview of an export.
struct ExportPreview {
  std::string unitsSentence; ///< units and axes in one sentence
  std::string sizeSentence;  ///< numbers of targets, rows and gaps, and the rate, in one sentence
  std::string text;          ///< first lines of a text file, or a description of a binary one
  // The same information as values, for messages in other languages.
  WorldAxes axes = WorldAxes::ZUp;
  LengthUnit unit = LengthUnit::Meter;
  std::size_t targetCount = 0;
  std::size_t rowCount = 0;
  std::size_t gapCount = 0;
  double rowsPerSecond = 0.0;
  /// Number of lines at the beginning of `text` that begin with '#': notes, and in some formats
  /// also the names of the columns.
  std::size_t noteLineCount = 0;
};

/// Writes the trajectory to `file` in the format `options.format`. If the format uses several
/// files, the others are written to the same folder. `file` is written last: its text goes to a
/// temporary file in the same folder, which is flushed and then renamed to `file`. A canceled or
/// failed export removes the files that it has created. Returns FileUnwritable, and the errors of
/// makeExportTable() and of the format.
Result<ExportSummary> exportTrajectory(const Trajectory& trajectory, const ExportOptions& options,
                                       const std::filesystem::path& file,
                                       const ExportProgress& progress = {});

/// Returns the first `lineCount` lines as exportTrajectory() would write them. Returns Canceled if
/// `progress` returned false.
Result<ExportPreview> previewExport(const Trajectory& trajectory, const ExportOptions& options,
                                    const std::filesystem::path& file, std::size_t lineCount = 40,
                                    const ExportProgress& progress = {});

/// Reads the trajectory of an export from a trajectory file or from the folder of a run.
Result<Trajectory> readExportSource(const std::filesystem::path& fileOrFolder);

} // namespace dewpoint::trajectory
