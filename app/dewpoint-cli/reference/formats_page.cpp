// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/reference/markdown.h"
#include "app/dewpoint-cli/reference/reference_pages.h"
#include "core/calibration/formats/format_catalog.h"
#include "core/trajectory/export/export_catalog.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace dewpoint::app {
namespace {

const char* axesText(WorldAxes axes) {
  return axes == WorldAxes::YUp ? "Y up" : "Z up";
}

std::string exportTable() {
  std::vector<std::vector<std::string>> rows;
  for (const ExportFormat& format : exportFormats()) {
    rows.push_back({markdownCode(format.id), markdownText(format.title),
                    markdownCode(format.suffix), markdownText(format.contentsSentence),
                    axesText(format.tableDefaults.axes),
                    format.tableDefaults.unit == LengthUnit::Meter ? "m" : "mm",
                    format.tableDefaults.requiresEvenlySpacedRows ? "at equal distances in time"
                                                                  : "as recorded",
                    format.hasFullCovariance ? "yes" : "no"});
  }
  return markdownTable(
      {"format", "name in the window", "file", "holds", "axes", "unit", "rows", "whole covariance"},
      rows);
}

std::string lensesText(const LensSupport& lenses) {
  const int count = lenses.pinholeCoefficientCount;
  const std::string pinhole = count >= 8   ? "k1 k2 p1 p2 k3 k4 k5 k6"
                              : count >= 5 ? "k1 k2 p1 p2 k3"
                                           : "k1 k2 p1 p2";
  return lenses.supportsFisheye ? pinhole + ", or fisheye" : pinhole;
}

std::string calibrationTable() {
  std::vector<std::vector<std::string>> rows;
  for (const CalibrationFormat& format : calibrationFormats()) {
    const bool isPerCamera = format.layout == FileLayout::FilePerCamera;
    rows.push_back({markdownCode(format.name), markdownText(format.title),
                    markdownText(format.description), lensesText(format.lensSupport),
                    isPerCamera ? "a file for each camera" : "all cameras together",
                    format.write == nullptr ? "read" : "read, written"});
  }
  return markdownTable({"format", "usual name", "holds", "lens coefficients", "files", "can be"},
                       rows);
}

} // namespace

std::string formatsPage() {
  return fmt::format("# File formats\n\n"
                     "## Trajectories\n\n"
                     "What *File › Export trajectory…* and `dewpoint-cli export` write. Axes, unit "
                     "and rows are those of a format unless you choose others: [Export]"
                     "(export.md).\n\n{}\n"
                     "## Calibrations\n\n"
                     "What *Calibration › Import calibration…* and *Export calibration…* and "
                     "`dewpoint-cli calibration convert` read and write: [Files of other tools]"
                     "(calibration.md#files-of-other-tools).\n\n{}",
                     exportTable(), calibrationTable());
}

} // namespace dewpoint::app
