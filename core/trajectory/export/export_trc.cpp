// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/csv_text.h"
#include "core/trajectory/export/export_encoders.h"

#include <fmt/format.h>

namespace dewpoint::trajectory::encoders {

EncodedFiles encodeTrc(const ExportTable& table, const std::string& name) {
  const std::size_t rows = table.rowCount();
  const double rate = table.rowsPerSecond;
  std::string text =
      fmt::format("PathFileType\t4\t(X/Y/Z)\t{}.trc\n"
                  "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\t"
                  "OrigDataStartFrame\tOrigNumFrames\n"
                  "{:.6g}\t{:.6g}\t{}\t{}\t{}\t{:.6g}\t1\t{}\n",
                  withoutLineBreaks(name), rate, rate, rows, table.targets.size(), table.unitName(),
                  table.recordedRowsPerSecond, table.recordedRowCount);
  text += "Frame#\tTime";
  for (const std::string& target : table.targets) {
    text += fmt::format("\t{}\t\t", withoutLineBreaks(target));
  }
  text += "\n\t";
  for (std::size_t k = 1; k <= table.targets.size(); ++k) {
    text += fmt::format("\tX{0}\tY{0}\tZ{0}", k);
  }
  text += "\n\n";
  for (std::size_t row = 0; row < rows; ++row) {
    text += fmt::format("{}\t{}", row + 1, timeText(table.times[row]));
    for (const auto& column : table.cells) {
      const ExportCell& cell = column[row];
      for (int axis = 0; axis < 3; ++axis) {
        text += '\t' + (cell.hasPosition ? lengthText(cell.position[axis]) : std::string());
      }
    }
    text += '\n';
  }
  return std::vector{ExportFile{"", std::move(text)}};
}

} // namespace dewpoint::trajectory::encoders
