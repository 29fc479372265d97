// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Small table of numbers from a CSV file. The file has a line with column names, followed by rows.
/// Lines that begin with # are comments; cells are not quoted.
struct ClipTable {
  /// Numbers of each row, with columns in the requested order.
  std::vector<std::vector<double>> rows;
  std::vector<std::string>
      wordCells; ///< cells of the word column, one per row; empty if no word column was requested
};

/// Reads `columns` of a file as numbers, and the column `wordColumn` as text unless its name is
/// empty. Errors: FileMissing, FileUnreadable, MissingKey with the name of a missing column, or
/// NotParsed with the line of a cell that is not a finite number or of a row that is too short.
Result<ClipTable> readClipTable(const std::filesystem::path& file,
                                const std::vector<std::string>& columns,
                                const std::string& wordColumn = {});

/// Largest frame number allowed in the table of a clip. It limits a list of all frames to 0.2 GB.
inline constexpr std::int64_t kMaxClipFrame = 1'000'000;

/// Checks that the first columns of a table, whose names are `names`, contain only whole numbers
/// from 0 to kMaxClipFrame. Returns NotParsed, with the file and the name of the column, if they do
/// not.
Status checkFrameColumns(const ClipTable& table, const std::vector<std::string>& names,
                         const std::filesystem::path& file);

} // namespace dewpoint::experiment
