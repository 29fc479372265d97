// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/csv_text.h"
#include "core/trajectory/export/export_encoders.h"

#include <fmt/format.h>

#include <cmath>

namespace dewpoint::trajectory::encoders {
namespace {

std::string symmetricCells(const Eigen::Matrix3d& c) {
  std::string text;
  for (const auto& [row, column] : {std::pair{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}) {
    text += ',' + covarianceText(c(row, column));
  }
  return text;
}

std::string covarianceCells(const ExportCell& cell) {
  if (!cell.covariance) {
    return std::string(9, ',');
  }
  const Eigen::Matrix3d& c = *cell.covariance;
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    text += ',' + covarianceText(std::sqrt(std::max(0.0, c(axis, axis))));
  }
  return text + symmetricCells(c);
}

std::string positionCells(const Eigen::Vector3d& p) {
  return fmt::format(",{},{},{}", lengthText(p.x()), lengthText(p.y()), lengthText(p.z()));
}

std::string tidyRow(const ExportCell& cell, const ExportTable& table) {
  std::string text = cell.hasPosition ? fmt::format("{}{},{},{},1,{}", positionCells(cell.position),
                                                    covarianceCells(cell), cell.cameraCount,
                                                    covarianceText(cell.effectiveSampleSize),
                                                    cell.isFilled ? 1 : 0)
                                      : std::string(13, ',') + "0,,0,0";
  if (table.hasBestParticles) {
    text += cell.bestParticle ? positionCells(*cell.bestParticle) : std::string(3, ',');
  }
  if (table.hasCorrectedCells) {
    text += cell.isCorrected ? ",1" : ",0";
  }
  if (table.hasAmbiguousCells) {
    text += cell.isAmbiguous ? ",1" : ",0";
  }
  if (table.hasExtent) {
    text += cell.extent ? symmetricCells(*cell.extent) : std::string(6, ',');
  }
  return text + '\n';
}

} // namespace

EncodedFiles encodeTidyCsv(const ExportTable& table, const std::string& /*name*/) {
  std::string text = commentHeader(table);
  text += fmt::format("time_s,frame,target,x_{0},y_{0},z_{0},sx_{0},sy_{0},sz_{0},cov_xx_{0}2,"
                      "cov_xy_{0}2,cov_xz_{0}2,cov_yy_{0}2,cov_yz_{0}2,cov_zz_{0}2,cameras,ess,"
                      "valid,filled",
                      table.unitName());
  text += table.hasBestParticles
              ? fmt::format(",best_x_{0},best_y_{0},best_z_{0}", table.unitName())
              : "";
  text += table.hasCorrectedCells ? ",corrected" : "";
  text += table.hasAmbiguousCells ? ",ambiguous" : "";
  text += table.hasExtent ? fmt::format(",extent_xx_{0}2,extent_xy_{0}2,extent_xz_{0}2,"
                                        "extent_yy_{0}2,extent_yz_{0}2,extent_zz_{0}2",
                                        table.unitName())
                          : "";
  text += '\n';
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    for (std::size_t target = 0; target < table.targets.size(); ++target) {
      text += fmt::format("{},{},{}", timeText(table.times[row]), table.frames[row],
                          csvCell(table.targets[target]));
      text += tidyRow(table.cells[target][row], table);
    }
  }
  return std::vector{ExportFile{"", std::move(text)}};
}

EncodedFiles encodeWideCsv(const ExportTable& table, const std::string& /*name*/) {
  std::string text = commentHeader(table) + "time_s,frame";
  for (const std::string& target : table.targets) {
    for (const char* axis : {"x", "y", "z"}) {
      text += ',' + csvCell(fmt::format("{}_{}_{}", target, axis, table.unitName()));
    }
  }
  text += '\n';
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    text += fmt::format("{},{}", timeText(table.times[row]), table.frames[row]);
    for (const auto& column : table.cells) {
      const ExportCell& cell = column[row];
      for (int axis = 0; axis < 3; ++axis) {
        text += ',' + (cell.hasPosition ? lengthText(cell.position[axis]) : std::string());
      }
    }
    text += '\n';
  }
  return std::vector{ExportFile{"", std::move(text)}};
}

} // namespace dewpoint::trajectory::encoders
