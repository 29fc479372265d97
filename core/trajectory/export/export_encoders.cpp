// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/export/export_encoders.h"

#include "core/trajectory/csv_text.h"

#include <fmt/format.h>

namespace dewpoint::trajectory::encoders {

std::string commentHeader(const ExportTable& table) {
  if (!table.writesHeader) {
    return {};
  }
  std::string text = "# dewpoint trajectory\n# " + unitsSentence(table) + '\n';
  for (const auto& [key, value] : table.headerEntries) {
    text += fmt::format("# {}: {}\n", withoutLineBreaks(key), withoutLineBreaks(value));
  }
  return text;
}

std::string lengthText(double value) {
  return fmt::format("{:.9g}", value);
}
std::string timeText(double value) {
  return fmt::format("{:.9g}", value);
}
std::string covarianceText(double value) {
  return fmt::format("{:.6g}", value);
}

} // namespace dewpoint::trajectory::encoders
