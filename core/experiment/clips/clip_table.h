// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Small table of numbers from a CSV file: a line with the column names, then rows. Lines that
/// begin with # are comments; cells are not quoted.
struct ClipTable {
  std::vector<std::vector<double>> rows; ///< columns in the requested order
  std::vector<std::string> words;        ///< word column, one per row; empty if none was requested
};

/// Reads the named columns of a file as numbers and `wordColumn`, if given, as text. FileMissing,
/// FileUnreadable; MissingKey names a missing column; NotParsed names the line of a cell that is
/// not a number, or of a row that is too short.
Result<ClipTable> readClipTable(const std::filesystem::path& file,
                                const std::vector<std::string>& columns,
                                const std::string& wordColumn = {});

} // namespace dewpoint::experiment
