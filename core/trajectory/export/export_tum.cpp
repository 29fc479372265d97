// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/csv_text.h"
#include "core/trajectory/export/export_encoders.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewpoint::trajectory::encoders {
namespace {

/// A part of a file name: letters, digits, and what is harmless.
std::string namePart(std::string text) {
  std::ranges::replace_if(
      text,
      [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 0x20 || byte == 0x7F ||
               std::string_view("/\\:*?\"<>| ").find(c) != std::string_view::npos;
      },
      '_');
  return text;
}

std::string nameSuffix(const ExportTable& table, std::size_t target) {
  if (table.targets.size() == 1) {
    return {};
  }
  const std::string part = namePart(table.targets[target]);
  // Names may differ only in what was replaced.
  const bool taken = std::ranges::count_if(table.targets, [&](const std::string& other) {
                       return namePart(other) == part;
                     }) > 1;
  return taken ? fmt::format("-{}-{}.tum", part, target + 1) : fmt::format("-{}.tum", part);
}

} // namespace

EncodedFiles encodeTum(const ExportTable& table, const std::string& /*name*/) {
  std::vector<ExportFile> files;
  for (std::size_t target = 0; target < table.targets.size(); ++target) {
    ExportFile& file =
        files.emplace_back(ExportFile{nameSuffix(table, target), commentHeader(table)});
    if (table.writesHeader) {
      file.bytes += fmt::format("# target: {}\n# timestamp tx ty tz qx qy qz qw\n",
                                withoutLineBreaks(table.targets[target]));
    }
    for (std::size_t row = 0; row < table.rowCount(); ++row) {
      const ExportCell& cell = table.cells[target][row];
      if (cell.hasPosition) {
        file.bytes += fmt::format("{:.6f} {} {} {} 0 0 0 1\n", table.times[row],
                                  lengthText(cell.position.x()), lengthText(cell.position.y()),
                                  lengthText(cell.position.z()));
      }
    }
  }
  return files;
}

} // namespace dewpoint::trajectory::encoders
