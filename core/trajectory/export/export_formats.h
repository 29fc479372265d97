// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/export/export_table.h"

#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::trajectory {

/// One file of an export. The main one is named as the user wants; others are named after it.
struct ExportFile {
  std::string nameEnd; ///< behind the chosen name without its suffix; empty: the main file
  std::string bytes;
};

/// A file format of other programs: a row of the catalog (export_catalog.h).
struct ExportFormat {
  std::string_view id;     ///< as on the command line
  std::string_view title;  ///< for people
  std::string_view suffix; ///< of the file name, with its dot
  std::string_view fields; ///< one sentence: what it holds
  TableRequest table;      ///< its usual axes, unit and rows
  bool covariance = false; ///< whether it can hold the whole of it
  bool binary = false;     ///< no text: the preview describes it
  /// The table as files, `name` (the chosen file's name without suffix) for those that hold one.
  /// BadValue when the format cannot hold the table.
  Result<std::vector<ExportFile>> (*encode)(const ExportTable& table, const std::string& name);
};

/// Units and axes of a table in one sentence: "Lengths in mm, times in s; Y points up ...".
std::string unitsSentence(const ExportTable& table);

} // namespace dewpoint::trajectory
