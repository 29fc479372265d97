// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// A small table of numbers from a CSV file: a line with the names of the columns, then rows. Lines
/// that begin with # are comments; cells are not quoted.
struct ClipTable {
  std::vector<std::vector<double>> rows; ///< in the order of the columns that were requested
  std::vector<std::string> words;        ///< per row, of the column of words; empty without one
};

/// Reads the named columns of a file, all numbers, and `wordColumn`, if one is named, as text.
/// FileMissing, FileUnreadable; MissingKey names a column that is not there; NotParsed the line of
/// a cell that is no number, or of a row that is too short.
Result<ClipTable> readClipTable(const std::filesystem::path& file,
                                const std::vector<std::string>& columns,
                                const std::string& wordColumn = {});

} // namespace dewpoint::experiment
