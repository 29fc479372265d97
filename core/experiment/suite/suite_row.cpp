// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/suite_row.h"

#include "core/base/text_number.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace dewpoint::experiment {
namespace {

constexpr std::size_t kKeyFields = 4;
constexpr const char* kKeyHeader = "scenario,grade,method,seed";

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + 1) {
    end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end == std::string::npos ? end : end - begin));
  }
  return parts;
}

std::string keyText(const RunKey& key) {
  return fmt::format("{},{},{},{}", key.scenario, gradeName(key.grade), key.method, key.seed);
}

std::optional<RunKey> parseKey(const std::vector<std::string>& fields) {
  if (fields.size() < kKeyFields || fields[0].empty() || fields[2].empty()) {
    return std::nullopt;
  }
  const auto grade = gradeFromName(fields[1]);
  const auto seed = toNumber<std::uint64_t>(fields[3]);
  return grade && seed ? std::optional(RunKey{fields[0], *grade, fields[2], *seed}) : std::nullopt;
}

std::string errorsText(const std::vector<double>& errors) {
  std::string text;
  for (const double error : errors) {
    if (!text.empty()) {
      text.push_back(' ');
    }
    text += std::isfinite(error) ? fmt::format("{:.4g}", error) : std::string(1, '-');
  }
  return text;
}

std::optional<std::vector<double>> parseErrors(const std::string& text) {
  std::vector<double> errors;
  for (const std::string& part : split(text, ' ')) {
    const auto value = part == "-" ? std::numeric_limits<double>::quiet_NaN()
                                   : toNumber<double>(part).value_or(-1.0);
    if (value < 0.0) {
      return std::nullopt;
    }
    errors.push_back(value);
  }
  return errors;
}

std::optional<ReliabilityCount> parseReliability(const std::string& text) {
  const auto parts = split(text, ':');
  if (parts.size() != 3) {
    return std::nullopt;
  }
  const auto count = toNumber<std::int64_t>(parts[0]);
  const auto sum = toNumber<double>(parts[1]);
  const auto hitCount = toNumber<std::int64_t>(parts[2]);
  return count && sum && hitCount ? std::optional(ReliabilityCount{*count, *sum, *hitCount})
                                  : std::nullopt;
}

} // namespace

std::optional<std::vector<Grade>> gradesFromNames(const std::vector<std::string>& names) {
  std::set<Grade> grades;
  for (const std::string& name : names) {
    if (name == "both") {
      grades.insert({Grade::Ideal, Grade::Room});
    } else if (const auto grade = gradeFromName(name)) {
      grades.insert(*grade);
    } else {
      return std::nullopt;
    }
  }
  return grades.empty() ? std::nullopt
                        : std::optional(std::vector<Grade>(grades.begin(), grades.end()));
}

std::span<const SuiteColumn> suiteColumns() {
  static constexpr std::array kColumns{
      SuiteColumn{"rmse_mm", &SuiteRow::rmseMm, "root mean square error after convergence"},
      SuiteColumn{"median_mm", &SuiteRow::medianErrorMm, "median error after convergence"},
      SuiteColumn{"p95_mm", &SuiteRow::p95ErrorMm,
                  "95th percentile of the error after convergence"},
      SuiteColumn{"max_mm", &SuiteRow::maxErrorMm, "largest error after convergence"},
      SuiteColumn{"depth_mm", &SuiteRow::depthErrorMm,
                  "RMS error along the mean viewing direction of the cameras"},
      SuiteColumn{"lateral_mm", &SuiteRow::lateralErrorMm, "RMS error across it"},
      SuiteColumn{"bias_mm", &SuiteRow::biasMm, "length of the mean error"},
      SuiteColumn{"depth_bias_mm", &SuiteRow::depthBiasMm,
                  "mean error along the viewing direction; positive: estimated too far away"},
      SuiteColumn{"jitter_mm", &SuiteRow::jitterMm,
                  "the part of the error that is new in each frame, after convergence: RMS second "
                  "difference of the error between successive frames, divided by sqrt(6)"},
      SuiteColumn{"frames_to_converge", &SuiteRow::framesToConverge,
                  "frames before the first five in a row within 30 mm; inf: never"},
      SuiteColumn{"frames_to_reacquire", &SuiteRow::framesToReacquire,
                  "the same after the worst jump, blackout or return; inf: never"},
      SuiteColumn{"frames_to_declare_loss", &SuiteRow::framesToDeclareLoss,
                  "frames a vanished target is still declared present, the worst; inf: for good"},
      SuiteColumn{"lost_percent", &SuiteRow::lostPercent,
                  "frames after convergence without an estimate within 30 mm"},
      SuiteColumn{"false_alarm_percent", &SuiteRow::falseAlarmPercent,
                  "frames with an estimate farther than 100 mm from every target"},
      SuiteColumn{"nees", &SuiteRow::nees,
                  "mean normalized estimation error squared; 3 is consistent"},
      SuiteColumn{"coverage95_percent", &SuiteRow::coverage95Percent,
                  "truths inside the stated 95 % ellipsoid"},
      SuiteColumn{"coverage50_percent", &SuiteRow::coverage50Percent,
                  "truths inside the stated 50 % ellipsoid"},
      SuiteColumn{"sure_and_wrong_percent", &SuiteRow::confidentlyWrongPercent,
                  "of all frames, those with P(exists) above 0.95 and the target absent or farther "
                  "off than three stated radii (root mean square errors by the covariance)"},
      SuiteColumn{"wrong_percent", &SuiteRow::wrongPercent,
                  "of all frames, those with the target declared, but absent or not within 30 mm"},
      SuiteColumn{"wrong_when_sure_percent", &SuiteRow::wrongWhenConfidentPercent,
                  "the same with P(exists) above 0.95"},
      SuiteColumn{"sure_of_tie_percent", &SuiteRow::confidentInTiePercent,
                  "where N objects are the target equally well: of all frames, those with the "
                  "target declared and P(exists) above 1 / N + 0.05"},
      SuiteColumn{"near_centroid_percent", &SuiteRow::nearCentroidPercent,
                  "of the frames after convergence with the target in sight, those with an "
                  "estimate within a quarter of the target's longest semi-axis"},
      SuiteColumn{"centroid_error_percent", &SuiteRow::centroidErrorPercent,
                  "median error after convergence, of the target's longest semi-axis"},
      SuiteColumn{"size_error_percent", &SuiteRow::sizeErrorPercent,
                  "where the size is not given and the method estimates it: median error of the "
                  "radius after convergence, of that of a ball of the target's volume"},
      SuiteColumn{"gospa_mm", &SuiteRow::gospaMm, "mean GOSPA, cutoff 100 mm, order 2"},
      SuiteColumn{"mota", &SuiteRow::mota, "multiple object tracking accuracy, gate 100 mm"},
      SuiteColumn{"hota", &SuiteRow::hota, "higher order tracking accuracy, gate 100 mm"},
      SuiteColumn{"identity_switches", &SuiteRow::identitySwitches, "of CLEAR MOT"},
      SuiteColumn{"existence_ece", &SuiteRow::existenceEce,
                  "expected calibration error of P(exists), ten bins"},
      SuiteColumn{"blackout_rmse_mm", &SuiteRow::blackoutRmseMm,
                  "RMS error while a camera (or all) is black; inf: nothing declared then"},
      SuiteColumn{"blackout_coverage95_percent", &SuiteRow::blackoutCoverage95Percent,
                  "truths inside the stated 95 % ellipsoid while a camera (or all) is black; what "
                  "is not declared counts as outside"},
      SuiteColumn{"largest_step_mm", &SuiteRow::largestStepMm,
                  "largest step of the error, mean of five frames before and after, where a camera "
                  "drops out or returns"},
      SuiteColumn{"rmse_px", &SuiteRow::rmsePx,
                  "of real clips: RMS distance in the images from the true centers, after "
                  "convergence; of clips of one camera over all frames"},
      SuiteColumn{"success", &SuiteRow::boxSuccess,
                  "of clips of one camera: area under the success curve of the boxes (Wu, Lim and "
                  "Yang 2013); lost frames and convergence count within the clip's radius there"},
      SuiteColumn{"us_per_frame", &SuiteRow::usPerFrame,
                  "processor time of the method per frame, microseconds, one thread"},
      SuiteColumn{"frames", &SuiteRow::frameCount, "frames of the run"},
  };
  return kColumns;
}

std::string rowHeader() {
  std::string text(kKeyHeader);
  for (const SuiteColumn& column : suiteColumns()) {
    text += fmt::format(",{}", column.name);
  }
  return text;
}

std::string rowText(const SuiteRow& row) {
  std::string text = keyText(row.key);
  for (const SuiteColumn& column : suiteColumns()) {
    const SuiteRow::Value& figure = row.*column.value;
    text += ',';
    if (figure && !std::isnan(*figure)) {
      text += fmt::format("{:.6g}", *figure);
    }
  }
  return text;
}

std::string traceHeader() {
  return fmt::format("{},errors_mm,reliability", kKeyHeader);
}

std::string traceText(const SuiteTrace& trace) {
  std::string errors;
  for (const auto& target : trace.errorsMm) {
    errors += fmt::format("{}{}", errors.empty() ? "" : ";", errorsText(target));
  }
  std::string bins;
  for (const ReliabilityCount& bin : trace.reliabilityCounts) {
    bins += fmt::format("{}{}:{:.6g}:{}", bins.empty() ? "" : " ", bin.count, bin.probabilitySum,
                        bin.hitCount);
  }
  return fmt::format("{},{},{}", keyText(trace.key), errors, bins);
}

std::optional<SuiteRow> parseRow(const std::string& line) {
  const auto fields = split(line, ',');
  const auto key = parseKey(fields);
  const auto columns = suiteColumns();
  // The last column always has a value: a line that was cut within it is recognized by its reader,
  // which knows whether the line was ended.
  if (!key || fields.size() != kKeyFields + columns.size() || fields.back().empty()) {
    return std::nullopt;
  }
  SuiteRow row;
  row.key = *key;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const std::string& field = fields[kKeyFields + k];
    if (!field.empty()) {
      const auto value = toNumber<double>(field);
      if (!value) {
        return std::nullopt;
      }
      row.*columns[k].value = value;
    }
  }
  return row;
}

std::optional<SuiteTrace> parseTrace(const std::string& line) {
  const auto fields = split(line, ',');
  const auto key = parseKey(fields);
  if (!key || fields.size() != kKeyFields + 2) {
    return std::nullopt;
  }
  SuiteTrace trace;
  trace.key = *key;
  for (const std::string& target : split(fields[kKeyFields], ';')) {
    auto errors = parseErrors(target);
    if (!errors) {
      return std::nullopt;
    }
    trace.errorsMm.push_back(std::move(*errors));
  }
  for (const std::string& text : split(fields[kKeyFields + 1], ' ')) {
    const auto bin = parseReliability(text);
    if (!bin) {
      return std::nullopt;
    }
    trace.reliabilityCounts.push_back(*bin);
  }
  return trace.reliabilityCounts.size() == kReliabilityBins ? std::optional(trace) : std::nullopt;
}

} // namespace dewpoint::experiment
