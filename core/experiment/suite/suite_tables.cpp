// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/suite_tables.h"

#include "core/experiment/suite/suite_figures.h"
#include "core/tracking/catalog/method_catalog.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::experiment {
namespace {

constexpr double kLostNotice = 0.05; // percent that is worth a word in the overview

std::string intervalText(const Interval& interval) {
  if (std::isnan(interval.value)) {
    return "-";
  }
  return fmt::format("{}<small>{}–{}</small>", formatValue(interval.value),
                     formatValue(interval.low), formatValue(interval.high));
}

std::string requirementOf(const SuiteRequirement& bar) {
  const std::string unit = bar.unit.empty() ? "" : " " + bar.unit;
  if (std::isinf(bar.lowerLimit)) {
    return fmt::format("≤ {:g}{}", bar.upperLimit, unit);
  }
  if (std::isinf(bar.upperLimit)) {
    return fmt::format("≥ {:g}{}", bar.lowerLimit, unit);
  }
  return bar.lowerLimit == bar.upperLimit
             ? fmt::format("{:g}{}", bar.upperLimit, unit)
             : fmt::format("{:g}–{:g}{}", bar.lowerLimit, bar.upperLimit, unit);
}

std::string assessmentOf(const RequirementResult& result) {
  if (!result.isMeasured()) {
    return "<span class='chip'>not measured</span>";
  }
  if (result.isMet()) {
    return "<span class='chip good'>✓ reached</span>";
  }
  const double shortfall = result.shortfall();
  const std::string unit = result.requirement->unit.empty() ? "" : " " + result.requirement->unit;
  return std::isinf(shortfall)
             ? std::string("<span class='chip bad'>✗ not reached</span>")
             : fmt::format("<span class='chip bad'>✗ by {}{}</span>", formatValue(shortfall), unit);
}

/// The figure, and the scenario that decides it.
std::string valueOf(const RequirementResult& result) {
  return formatValue(result.value) +
         (result.scenario.empty()
              ? std::string()
              : fmt::format("<br><small>{}</small>", htmlEscaped(result.scenario)));
}

std::string beliefCell(const ScenarioSummary& figure) {
  if (std::isnan(figure.medianValue)) {
    return "<td>-</td>";
  }
  return fmt::format("<td>{}<br><small>{} in {}</small></td>", formatValue(figure.medianValue),
                     formatValue(figure.worstValue), htmlEscaped(figure.worstScenario));
}

std::string methodName(const std::string& method) {
  return fmt::format("<span class='{}'><span class='dot'></span>{}</span>",
                     plotStyleOfMethod(method), htmlEscaped(method));
}

struct TableColumn {
  const char* head;
  std::string (*text)(const SuiteCell&);
  bool ofMany = false; ///< says something new with several targets only
};

template <SuiteRow::Value SuiteRow::*Member> std::string medianText(const SuiteCell& cell) {
  return formatValue(columnQuantile(cell.runs, Member, 0.5));
}

template <SuiteRow::Value SuiteRow::*Member> std::string meanText(const SuiteCell& cell) {
  return formatValue(meanOf(cell.runs, Member));
}

std::string countText(const Proportion& proportion) {
  return fmt::format("{}/{}", proportion.count, proportion.total);
}

const std::vector<TableColumn>& tableColumns() {
  static const std::vector<TableColumn> columns{
      {"median RMSE<br>mm, 95 %", [](const SuiteCell& c) { return intervalText(c.rmseMm); }},
      {"p95 of frames<br>mm, 95 %", [](const SuiteCell& c) { return intervalText(c.p95ErrorMm); }},
      {"depth<br>mm", medianText<&SuiteRow::depthErrorMm>},
      {"lateral<br>mm", medianText<&SuiteRow::lateralErrorMm>},
      {"bias<br>mm", medianText<&SuiteRow::biasMm>},
      {"jitter<br>mm", medianText<&SuiteRow::jitterMm>},
      {"lost<br>%", meanText<&SuiteRow::lostPercent>},
      {"false<br>alarms %", meanText<&SuiteRow::falseAlarmPercent>},
      {"within<br>5 frames", [](const SuiteCell& c) { return countText(c.quicklyConverged); }},
      {"converged<br>at all", [](const SuiteCell& c) { return countText(c.converged); }},
      {"frames to<br>re-acquire", medianText<&SuiteRow::framesToReacquire>},
      {"while blind<br>mm", medianText<&SuiteRow::blackoutRmseMm>},
      {"in 95 %<br>while blind %", meanText<&SuiteRow::blackoutCoverage95Percent>},
      {"step<br>mm", medianText<&SuiteRow::largestStepMm>},
      {"NEES", medianText<&SuiteRow::nees>},
      {"in 50 %<br>ellipsoid %", meanText<&SuiteRow::coverage50Percent>},
      {"in 95 %<br>ellipsoid %", meanText<&SuiteRow::coverage95Percent>},
      {"ECE of<br>P(exists)",
       [](const SuiteCell& c) {
         return formatValue(pooledReliability(c.runs).expectedCalibrationError);
       }},
      {"sure and<br>wrong %", meanText<&SuiteRow::confidentlyWrongPercent>},
      {"declared, not<br>within 30 mm %", meanText<&SuiteRow::wrongPercent>},
      {"sure of<br>a tie %", meanText<&SuiteRow::confidentInTiePercent>},
      {"near the<br>centroid %", meanText<&SuiteRow::nearCentroidPercent>},
      {"error in %<br>of extent", medianText<&SuiteRow::centroidErrorPercent>},
      {"error of<br>radius %", medianText<&SuiteRow::sizeErrorPercent>},
      {"GOSPA<br>mm", medianText<&SuiteRow::gospaMm>},
      {"MOTA", medianText<&SuiteRow::mota>, true},
      {"HOTA", medianText<&SuiteRow::hota>, true},
      {"identity<br>switches", meanText<&SuiteRow::identitySwitches>, true},
      {"RMSE in<br>images px", medianText<&SuiteRow::rmsePx>},
      {"success<br>of boxes", medianText<&SuiteRow::boxSuccess>},
      {"µs per<br>frame", medianText<&SuiteRow::usPerFrame>},
  };
  return columns;
}

std::vector<std::string> methodsOf(std::span<const SuiteCell> cells) {
  std::vector<std::string> methods;
  for (const SuiteCell& cell : cells) {
    if (std::ranges::find(methods, cell.method) == methods.end()) {
      methods.push_back(cell.method);
    }
  }
  std::ranges::stable_sort(methods, {}, plotStyleOfMethod);
  return methods;
}

std::size_t targetCount(std::span<const SuiteCell> cells) {
  return cells.front().runs.front()->trace.errorsMm.size();
}

/// The RMSE of the overview: in millimeters, or in pixels where nothing else is known.
struct OverviewError {
  double value = 0.0;
  const char* unit = "";
};

/// `inPixels`: no method of the row has an error in millimeters.
OverviewError overviewError(const SuiteCell& cell, bool inPixels) {
  return inPixels ? OverviewError{columnQuantile(cell.runs, &SuiteRow::rmsePx, 0.5), " px"}
                  : OverviewError{cell.rmseMm.value, ""};
}

/// The cells of one scenario and grade, from the first on.
std::span<const SuiteCell> firstRow(std::span<const SuiteCell> cells) {
  const auto end = std::ranges::find_if(cells, [&](const SuiteCell& cell) {
    return cell.scenario != cells.front().scenario || cell.grade != cells.front().grade;
  });
  return cells.first(static_cast<std::size_t>(end - cells.begin()));
}

std::string rowHead(const SuiteCell& cell) {
  return fmt::format("<tr><td>{}</td><td class='text soft'>{}</td>", htmlEscaped(cell.scenario),
                     gradeName(cell.grade));
}

/// A table with a row for each scenario and grade; `rowOf` gets its cells and the methods.
template <class RowOf>
std::string scenarioByMethod(std::span<const SuiteCell> cells, const RowOf& rowOf) {
  const auto methods = methodsOf(cells);
  std::string text = "<div class='scroll'><table><thead><tr><th>scenario</th><th "
                     "class='text'>grade</th>";
  for (const std::string& method : methods) {
    text += fmt::format("<th>{}</th>", methodName(method));
  }
  text += "</tr></thead><tbody>";
  while (!cells.empty()) {
    const auto row = firstRow(cells);
    text += rowOf(row, methods);
    cells = cells.subspan(row.size());
  }
  return text + "</tbody></table></div>";
}

/// "-" for what was not run, and for clips without lengths.
std::string extentRow(std::span<const SuiteCell> row, const std::vector<std::string>& methods) {
  std::string text = rowHead(row.front());
  for (const std::string& method : methods) {
    const auto cell = std::ranges::find(row, method, &SuiteCell::method);
    const double near =
        cell == row.end() ? kNoValue : meanOf(cell->runs, &SuiteRow::nearCentroidPercent);
    const double size =
        cell == row.end() ? kNoValue : columnQuantile(cell->runs, &SuiteRow::sizeErrorPercent, 0.5);
    text += fmt::format("<td>{}{}</td>", formatValue(near),
                        std::isnan(size)
                            ? std::string()
                            : fmt::format("<small>radius off by {} %</small>", formatValue(size)));
  }
  return text + "</tr>";
}

/// "-" for what was not run; the smallest RMSE of the row is marked.
std::string overviewRow(std::span<const SuiteCell> row, const std::vector<std::string>& methods) {
  const bool inPixels =
      std::ranges::all_of(row, [](const SuiteCell& cell) { return std::isnan(cell.rmseMm.value); });
  const auto best = std::ranges::min_element(row, {}, [&](const SuiteCell& cell) {
    const double value = overviewError(cell, inPixels).value;
    return std::isnan(value) ? INFINITY : value;
  });
  std::string text = rowHead(row.front());
  for (const std::string& method : methods) {
    const auto cell = std::ranges::find(row, method, &SuiteCell::method);
    if (cell == row.end()) {
      text += "<td>-</td>";
      continue;
    }
    const double lost = meanOf(cell->runs, &SuiteRow::lostPercent);
    const OverviewError error = overviewError(*cell, inPixels);
    const bool known = !std::isnan(error.value);
    text +=
        fmt::format("<td{}>{}{}{}</td>", cell == best && known ? " class='best'" : "",
                    formatValue(error.value), known ? error.unit : "",
                    lost >= kLostNotice ? fmt::format("<small>{} % lost</small>", formatValue(lost))
                                        : std::string());
  }
  return text + "</tr>";
}

} // namespace

std::string formatValue(double value) {
  if (std::isnan(value)) {
    return "-";
  }
  if (std::isinf(value)) {
    return "never";
  }
  const double size = std::abs(value);
  if (size >= 1e6) {
    return fmt::format("{:.1e}", value);
  }
  if (value == std::round(value)) {
    return fmt::format("{:.0f}", value);
  }
  return size >= 100.0  ? fmt::format("{:.0f}", value)
         : size >= 10.0 ? fmt::format("{:.1f}", value)
         : size >= 0.01 ? fmt::format("{:.2f}", value)
                        : fmt::format("{:.1g}", value);
}

std::string requirementTable(std::span<const RequirementResult> requirements) {
  std::string text =
      "<div class='scroll'><table><thead><tr><th>No.</th><th class='text'>What</th><th>must "
      "be</th><th>is</th><th>runs</th><th class='text'>result</th></tr></thead><tbody>";
  for (const RequirementResult& result : requirements) {
    const char* const aim =
        result.requirement->isAimForNextVersion ? " <span class='chip'>next version</span>" : "";
    text += fmt::format("<tr><td>{}</td><td class='text'>{}{}</td><td>{}</td><td>{}</td><td>{}</td>"
                        "<td class='text'>{}</td></tr>",
                        result.requirement->number, htmlEscaped(result.requirement->description),
                        aim, requirementOf(*result.requirement), valueOf(result), result.runCount,
                        assessmentOf(result));
  }
  return text + "</tbody></table></div>";
}

std::string beliefTable(std::span<const BeliefSummary> methods) {
  std::string text = "<div class='scroll'><table><thead><tr><th>method</th><th>scenarios</th>";
  for (const BeliefMetric& metric : beliefMetrics()) {
    text += fmt::format("<th>{}</th>", metric.headerHtml);
  }
  text += "</tr></thead><tbody>";
  for (const BeliefSummary& summary : methods) {
    text += fmt::format("<tr{}><td>{}</td><td>{}</td>",
                        summary.method == defaultMethod() ? " class='ours'" : "",
                        methodName(summary.method), summary.scenarioCount);
    for (const ScenarioSummary& figure : summary.metricSummaries) {
      text += beliefCell(figure);
    }
    text += "</tr>";
  }
  return text + "</tbody></table></div>";
}

std::string overviewTable(std::span<const SuiteCell> cells) {
  return scenarioByMethod(cells, overviewRow);
}

std::string extentTable(std::span<const SuiteCell> cells) {
  return scenarioByMethod(cells, extentRow);
}

std::string scenarioTable(std::span<const SuiteCell> cells) {
  std::vector<const TableColumn*> shown; // a column without a figure is left out
  for (const TableColumn& column : tableColumns()) {
    const bool useful = !column.ofMany || targetCount(cells) > 1;
    if (useful &&
        std::ranges::any_of(cells, [&](const auto& cell) { return column.text(cell) != "-"; })) {
      shown.push_back(&column);
    }
  }
  std::string text = "<div class='scroll'><table><thead><tr><th>method</th>";
  for (const TableColumn* column : shown) {
    text += fmt::format("<th>{}</th>", column->head);
  }
  text += "</tr></thead><tbody>";
  for (const SuiteCell& cell : cells) {
    text += fmt::format("<tr{}><td>{}</td>", cell.method == defaultMethod() ? " class='ours'" : "",
                        methodName(cell.method));
    for (const TableColumn* column : shown) {
      text += fmt::format("<td>{}</td>", column->text(cell));
    }
    text += "</tr>";
  }
  return text + "</tbody></table></div>";
}

} // namespace dewpoint::experiment
