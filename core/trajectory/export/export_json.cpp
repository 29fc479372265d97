// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/export/export_encoders.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace dewpoint::trajectory::encoders {
namespace {

/// A name that is no UTF-8 gets replacement characters.
std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string headerLine(const ExportTable& table) {
  std::string text = fmt::format("{{\"format\":\"dewpoint trajectory\",\"units\":{}",
                                 quoted(unitsSentence(table)));
  for (const auto& [key, value] : table.headerEntries) {
    text += fmt::format(",{}:{}", quoted(key), quoted(value));
  }
  return text + "}\n";
}

std::string matrixText(const Eigen::Matrix3d& c) {
  std::string text;
  for (int row = 0; row < 3; ++row) {
    text += fmt::format("{}[{},{},{}]", row == 0 ? "[" : ",", covarianceText(c(row, 0)),
                        covarianceText(c(row, 1)), covarianceText(c(row, 2)));
  }
  return text + ']';
}

std::string vectorText(const Eigen::Vector3d& p) {
  return fmt::format("[{},{},{}]", lengthText(p.x()), lengthText(p.y()), lengthText(p.z()));
}

std::string targetText(const std::string& name, const ExportCell& cell) {
  std::string text = fmt::format("{{\"id\":{},\"xyz\":{}", quoted(name), vectorText(cell.position));
  if (cell.covariance) {
    text += fmt::format(",\"cov\":{}", matrixText(*cell.covariance));
  }
  if (cell.bestParticle) {
    text += fmt::format(",\"best\":{}", vectorText(*cell.bestParticle));
  }
  if (cell.extent) {
    text += fmt::format(",\"extent\":{}", matrixText(*cell.extent));
  }
  return text + fmt::format(",\"cams\":{},\"ess\":{}{}{}{}}}", cell.cameraCount,
                            covarianceText(cell.effectiveSampleSize),
                            cell.isFilled ? ",\"filled\":true" : "",
                            cell.isCorrected ? ",\"corrected\":true" : "",
                            cell.isAmbiguous ? ",\"ambiguous\":true" : "");
}

} // namespace

EncodedFiles encodeJsonLines(const ExportTable& table, const std::string& /*name*/) {
  std::string text = table.writesHeader ? headerLine(table) : std::string();
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    text += fmt::format("{{\"t\":{},\"frame\":{},\"targets\":[", timeText(table.times[row]),
                        table.frames[row]);
    bool first = true;
    for (std::size_t target = 0; target < table.targets.size(); ++target) {
      const ExportCell& cell = table.cells[target][row];
      if (cell.hasPosition) {
        text.append(first ? "" : ",").append(targetText(table.targets[target], cell));
        first = false;
      }
    }
    text += "]}\n";
  }
  return std::vector{ExportFile{"", std::move(text)}};
}

} // namespace dewpoint::trajectory::encoders
