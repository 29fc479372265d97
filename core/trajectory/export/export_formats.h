// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/export/export_table.h"

#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::trajectory {

/// One file of an export. The main file has the name that the user chose; the names of the others
/// are derived from it.
struct ExportFile {
  /// Text that replaces the suffix of the name that the user chose; empty for the main file.
  std::string nameSuffix;
  std::string bytes;
};

/// An export file format: one entry of the catalog (export_catalog.h).
struct ExportFormat {
  std::string_view id;               ///< name on the command line
  std::string_view title;            ///< name shown to the user
  std::string_view suffix;           ///< file name suffix, including the dot
  std::string_view contentsSentence; ///< contents of the file in one sentence
  TableDefaults tableDefaults;       ///< default axes, unit and rows
  bool hasFullCovariance = false;    ///< true if the file holds the full covariance
  /// True if the file is not text; the preview then shows a description of the file.
  bool isBinary = false;
  /// Encodes the table as one or more files. `name` is the name of the chosen file without suffix,
  /// for formats that store a name. Returns BadValue if the format cannot hold the table.
  Result<std::vector<ExportFile>> (*encode)(const ExportTable& table, const std::string& name);
  /// True if the file can hold notes about the run, which ExportOptions::writesHeader can leave
  /// out.
  bool hasNotes = true;
};

/// Returns units and axes of a table in one sentence: "Lengths in mm, times in s; Y points up ...".
std::string unitsSentence(const ExportTable& table);

} // namespace dewpoint::trajectory
