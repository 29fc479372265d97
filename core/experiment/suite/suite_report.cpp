// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/suite_report.h"

#include "core/base/text_file.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/suite/suite_page.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace dewpoint::experiment {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no number for what is not finite: text for never, null for nothing.
Json number(double value) {
  if (std::isnan(value)) {
    return nullptr;
  }
  return std::isinf(value) ? Json(value > 0.0 ? "inf" : "-inf") : Json(value);
}

Json interval(const Interval& value) {
  return {{"value", number(value.value)}, {"low", number(value.low)}, {"high", number(value.high)}};
}

Json barJson(const RequirementResult& result) {
  Json json;
  json["item"] = result.requirement->number;
  json["grade"] = result.requirement->grade;
  json["next_version"] = result.requirement->isAimForNextVersion;
  json["requirement"] = result.requirement->description;
  json["scenarios"] = result.requirement->scenarios;
  json["unit"] = result.requirement->unit;
  json["low"] = number(result.requirement->lowerLimit);
  json["high"] = number(result.requirement->upperLimit);
  json["runs"] = result.runCount;
  json["value"] = number(result.value);
  json["scenario"] = result.scenario.empty() ? Json(nullptr) : Json(result.scenario);
  json["shortfall"] = result.isMeasured() ? number(result.shortfall()) : Json(nullptr);
  json["verdict"] = !result.isMeasured() ? "not measured"
                    : result.isMet()     ? "reached"
                                         : "not reached";
  return json;
}

Json beliefJson(const BeliefSummary& summary) {
  Json json;
  json["grade"] = gradeName(summary.grade);
  json["method"] = summary.method;
  json["scenarios"] = summary.scenarioCount;
  json["runs"] = summary.runCount;
  for (std::size_t k = 0; k < summary.metricSummaries.size(); ++k) {
    const ScenarioSummary& figure = summary.metricSummaries[k];
    json["figures"][beliefMetrics()[k].name] = {{"median", number(figure.medianValue)},
                                                {"worst", number(figure.worstValue)},
                                                {"worst_scenario", figure.worstScenario}};
  }
  return json;
}

Json skippedJson(const SkippedRun& run) {
  Json json;
  json["scenario"] = run.scenario;
  json["grade"] = gradeName(run.grade);
  json["seed"] = run.seed;
  json["reason"] = run.reason;
  return json;
}

Json cellJson(const SuiteCell& cell) {
  Json json;
  json["scenario"] = cell.scenario;
  json["grade"] = gradeName(cell.grade);
  json["method"] = cell.method;
  json["runs"] = cell.runs.size();
  json["median_rmse_mm"] = interval(cell.rmseMm);
  json["pooled_p95_mm"] = interval(cell.p95ErrorMm);
  json["converged_within_5_frames"] = cell.quicklyConverged.count;
  json["converged"] = cell.converged.count;
  json["pooled_existence_ece"] = number(pooledReliability(cell.runs).expectedCalibrationError);
  for (const SuiteColumn& column : suiteColumns()) {
    json["runs_median"][column.name] = number(columnQuantile(cell.runs, column.value, 0.5));
    json["runs_mean"][column.name] = number(meanOf(cell.runs, column.value));
    json["runs_p90"][column.name] = number(columnQuantile(cell.runs, column.value, 0.9));
  }
  return json;
}

std::string csvNumber(double value) {
  return std::isnan(value) ? std::string() : fmt::format("{:.6g}", value);
}

} // namespace

std::string summaryCsv(const SuiteReport& report) {
  std::string text = "scenario,grade,method,runs,median_rmse_mm,median_rmse_low_mm,"
                     "median_rmse_high_mm,pooled_p95_mm,pooled_p95_low_mm,pooled_p95_high_mm,"
                     "converged_within_5_frames,converged";
  for (const SuiteColumn& column : suiteColumns()) {
    text += fmt::format(",median_{}", column.name);
  }
  text += '\n';
  for (const SuiteCell& cell : report.cells) {
    text += fmt::format("{},{},{},{}", cell.scenario, gradeName(cell.grade), cell.method,
                        cell.runs.size());
    for (const double value : {cell.rmseMm.value, cell.rmseMm.low, cell.rmseMm.high,
                               cell.p95ErrorMm.value, cell.p95ErrorMm.low, cell.p95ErrorMm.high}) {
      text += fmt::format(",{}", csvNumber(value));
    }
    text += fmt::format(",{},{}", cell.quicklyConverged.count, cell.converged.count);
    for (const SuiteColumn& column : suiteColumns()) {
      text += fmt::format(",{}", csvNumber(columnQuantile(cell.runs, column.value, 0.5)));
    }
    text += '\n';
  }
  return text;
}

std::string beliefCsv(const SuiteReport& report) {
  std::string text = "grade,method,scenarios,runs,figure,median,worst,worst_scenario\n";
  for (const BeliefSummary& summary : report.beliefSummaries) {
    for (std::size_t k = 0; k < summary.metricSummaries.size(); ++k) {
      const ScenarioSummary& figure = summary.metricSummaries[k];
      text += fmt::format("{},{},{},{},{},{},{},{}\n", gradeName(summary.grade), summary.method,
                          summary.scenarioCount, summary.runCount, beliefMetrics()[k].name,
                          csvNumber(figure.medianValue), csvNumber(figure.worstValue),
                          figure.worstScenario);
    }
  }
  return text;
}

std::string reportJson(const SuiteReport& report) {
  Json json;
  json["version"] = DEWPOINT_VERSION;
  json["seeds"] = report.seeds;
  json["seeds_sentence"] = describeSeeds(report.seeds);
  json["reporting_seeds"] = areReportingSeeds(report.seeds);
  json["notes"] = report.notes;
  json["skipped"] = Json::array();
  for (const SkippedRun& run : report.skippedRuns) {
    json["skipped"].push_back(skippedJson(run));
  }
  json["bars"] = Json::array();
  for (const RequirementResult& result : report.requirements) {
    json["bars"].push_back(barJson(result));
  }
  json["belief"] = Json::array();
  for (const BeliefSummary& summary : report.beliefSummaries) {
    json["belief"].push_back(beliefJson(summary));
  }
  json["cells"] = Json::array();
  for (const SuiteCell& cell : report.cells) {
    json["cells"].push_back(cellJson(cell));
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Status writeSuiteReport(const std::filesystem::path& folder, const SuiteResults& results,
                        const std::vector<RunKey>& order,
                        std::span<const ScenarioDeclaration> catalog,
                        const std::vector<std::string>& notes, const SkippedRuns& skipped) {
  SuiteReport report;
  report.cells = summarizeSuite(results, order);
  report.beliefSummaries = summarizeBelief(report.cells);
  report.requirements = measureRequirements(report.cells);
  report.catalog = catalog;
  report.notes = notes;
  report.skippedRuns = skipped;
  std::set<std::uint64_t> seeds;
  for (const RunKey& key : order) {
    seeds.insert(key.seed);
  }
  report.seeds.assign(seeds.begin(), seeds.end());
  if (auto written = writeTextFile(folder / "summary.csv", summaryCsv(report)); !written) {
    return written;
  }
  if (auto written = writeTextFile(folder / "belief.csv", beliefCsv(report)); !written) {
    return written;
  }
  if (auto written = writeTextFile(folder / "report.json", reportJson(report)); !written) {
    return written;
  }
  return writeTextFile(folder / "report.html", reportHtml(report));
}

} // namespace dewpoint::experiment
