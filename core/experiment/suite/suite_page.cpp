// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/suite_page.h"

#include "core/experiment/metrics/extent_errors.h"
#include "core/experiment/report/report_style.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/suite/suite_figures.h"
#include "core/experiment/suite/suite_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace dewpoint::experiment {
namespace {

/// A family's heading, where it is known.
std::string familyTitle(const std::string& family) {
  static const std::vector<std::pair<std::string, std::string>> titles{
      {"S0", "A single ball, nothing in the way"},
      {"S1", "Distractors of the same color"},
      {"S2", "Half of the disk hidden in one camera"},
      {"S3", "Blackouts and absences"},
      {"S4", "Random starts and jumps"},
      {"S5", "Identical targets that cross"},
      {"S6", "More cameras, and cameras that fail"},
      {"S7", "Cameras out of step"},
      {"S8", "Changing light"},
      {"S9", "A camera that was moved"},
      {"S10", "A ball of unknown size"},
      {"S11", "Held in a hand"},
      {"S12", "A patterned ball"},
      {"S13", "Its own color behind it"},
      {"S14", "What cameras do to images"},
      {"S15", "Cameras and time"},
      {"S16", "A calibration that drifts"},
      {"S17", "Out of view"},
      {"S18", "Thrown, bouncing, spinning"},
      {"S19", "A crowd of identical objects"},
      {"S20", "Hard light"},
      {"S21", "Shapes other than balls"},
      {"S22", "Learned by one click"},
      {"R1", "Real clips of calibrated cameras"},
      {"R2", "Real clips of one camera"}};
  const auto found = std::ranges::find(titles, family, &std::pair<std::string, std::string>::first);
  return found == titles.end() ? family : family + " · " + found->second;
}

std::string head(const SuiteReport& report) {
  std::size_t runs = 0;
  for (const SuiteCell& cell : report.cells) {
    runs += cell.runs.size();
  }
  const bool quotable = areReportingSeeds(report.seeds);
  const std::string seeds = htmlEscaped(describeSeeds(report.seeds));
  return fmt::format("<header><h1>Dewpoint accuracy suite</h1><p class='meta'>Version {} · {} runs "
                     "· seeds {}</p>{}</header>",
                     DEWPOINT_VERSION, runs, seeds,
                     quotable ? std::string()
                              : fmt::format("<p class='note'>Seeds {}. Seeds {} to {} are for "
                                            "reporting.</p>",
                                            seeds, kFirstReportingSeed, kLastReportingSeed));
}

/// Runs that their scenarios could not make.
std::string skippedRuns(const SuiteReport& report) {
  if (report.skippedRuns.empty()) {
    return {};
  }
  std::string text =
      fmt::format("<details class='note'><summary>Skipped runs: {}. The random draws for these "
                  "seeds did not fit the scenario. The results do not contain them.</summary><ul>",
                  report.skippedRuns.size());
  for (const SkippedRun& run : report.skippedRuns) {
    text += fmt::format("<li>{}</li>", htmlEscaped(skippedRunDescription(run)));
  }
  return text + "</ul></details>";
}

/// What the report lacks, and why: clips whose recordings are not there, and skipped runs.
std::string notesOf(const SuiteReport& report) {
  std::string text;
  for (const std::string& note : report.notes) {
    text += fmt::format("<p class='note'>{}</p>", htmlEscaped(note));
  }
  return text + skippedRuns(report);
}

std::string tile(const char* style, std::ptrdiff_t count, const char* words) {
  return fmt::format("<div class='tile {}'><div class='count'>{}</div>{}</div>", style, count,
                     words);
}

/// What the images of a grade are like, where it is known.
std::string gradeSentence(const std::string& grade) {
  static const std::vector<std::pair<std::string, std::string>> sentences{
      {"ideal", "Sensor noise, shading and clutter; the calibration is exact."},
      {"room", "What ordinary cameras and a calibration by hand do to the images."},
      {"wild", "The same, stronger, in rooms and with cameras that are drawn per seed."},
      {"real", "Recordings."}};
  const auto found =
      std::ranges::find(sentences, grade, &std::pair<std::string, std::string>::first);
  return found == sentences.end() ? std::string() : found->second;
}

/// The bars of one grade.
std::string requirementsOf(const SuiteReport& report, const std::string& grade) {
  std::vector<RequirementResult> bars;
  std::ranges::copy_if(
      report.requirements, std::back_inserter(bars),
      [&](const RequirementResult& result) { return result.requirement->grade == grade; });
  return fmt::format("<h3>Grade {}</h3><p>{}</p>", htmlEscaped(grade),
                     htmlEscaped(gradeSentence(grade))) +
         requirementTable(bars);
}

/// How many are reached of the bars of this version, or of those that the next one aims at.
std::string tiles(const SuiteReport& report, bool aims, const char* caption) {
  std::ptrdiff_t reached = 0;
  std::ptrdiff_t missed = 0;
  std::ptrdiff_t open = 0;
  for (const RequirementResult& result : report.requirements) {
    if (result.requirement->isAimForNextVersion == aims) {
      ++(!result.isMeasured() ? open : result.isMet() ? reached : missed);
    }
  }
  return fmt::format("<p class='soft'>{}</p><div class='tiles'>", caption) +
         tile("good", reached, "reached") + tile("bad", missed, "not reached") +
         tile("", open, "not measured") + "</div>";
}

std::string requirements(const SuiteReport& report) {
  std::string text =
      "<h2 id='bars'>What must be reached</h2><p>Method <b>dewpoint</b>, grade by grade. The "
      "scenario that decides a value is named below it. <span class='chip'>next version</span> "
      "marks a goal of the next version, with what this version reaches.</p>" +
      tiles(report, false, "This version") + tiles(report, true, "Next version");
  std::set<std::string> done;
  for (const RequirementResult& result : report.requirements) {
    if (done.insert(result.requirement->grade).second) {
      text += requirementsOf(report, result.requirement->grade);
    }
  }
  return text;
}

std::string belief(const SuiteReport& report) {
  std::string text =
      "<h2 id='belief'>Is its confidence justified?</h2><p>Every number is computed for each "
      "scenario. The table shows the median over the scenarios and, in gray, the worst value with "
      "the name of its scenario. For a method that states its uncertainty correctly, the "
      "ellipsoids contain 50 and 95 % of the true positions, and NEES is 3. For methods without "
      "P(exists), it counts as 1 whenever they declare a target. “Sure of a tie” uses only "
      "scenarios in which several objects could be the target equally well.</p>";
  const std::span<const BeliefSummary> all(report.beliefSummaries);
  for (std::size_t begin = 0; begin < all.size();) {
    std::size_t end = begin;
    while (end < all.size() && all[end].grade == all[begin].grade) {
      ++end;
    }
    text += fmt::format("<h3>Grade {}</h3>", gradeName(all[begin].grade)) +
            beliefTable(all.subspan(begin, end - begin));
    begin = end;
  }
  return text;
}

std::string overview(const SuiteReport& report) {
  return "<h2 id='overview'>At a glance</h2><p>The median over the runs of the RMSE after "
         "convergence, in millimeters (px: in pixels, for clips without lengths). The smallest "
         "value of each row is bold. If a notable share of the frames is lost, the share is given "
         "beside the value: a small error in few frames is no success.</p>" +
         overviewTable(report.cells);
}

/// Nothing where no run knows how large its targets are.
std::string extents(const SuiteReport& report) {
  if (std::ranges::all_of(report.cells, [](const SuiteCell& cell) {
        return std::isnan(meanOf(cell.runs, &SuiteRow::nearCentroidPercent));
      })) {
    return {};
  }
  return fmt::format(
             "<h2 id='extents'>Measured by the target's size</h2><p>Percent of the frames "
             "after convergence, with the target in sight, in which the estimate is within "
             "{:g} of the target's longest semi-axis from its centroid: mean over the "
             "runs. Where methods estimate the size because it is not given, the median error "
             "of the radius is beside it, compared with a ball of the target's volume.</p>",
             kNearFraction) +
         extentTable(report.cells);
}

std::string legendOf(std::span<const SuiteCell> cells) {
  std::string text = "<div class='legend'>";
  for (const SuiteCell& cell : cells) {
    text += fmt::format("<span class='{}'>{}</span>", plotStyleOfMethod(cell.method),
                        htmlEscaped(cell.method));
  }
  return text + "</div>";
}

std::string figureOf(const char* caption, const Plot& plot) {
  return fmt::format("<figure><figcaption>{}</figcaption>{}</figure>", caption, renderSvg(plot));
}

/// Clips that are measured in pixels have no errors to draw, those of one camera no P(exists).
std::string plotsOf(std::span<const SuiteCell> cells) {
  std::string plots;
  if (std::ranges::any_of(cells, [](const auto& cell) { return !std::isnan(cell.rmseMm.value); })) {
    plots += figureOf("Error over time: median, 10th to 90th percentile", errorOverTime(cells));
    plots += figureOf("Share of all frames with at most this error", errorDistribution(cells));
  }
  if (std::ranges::any_of(
          cells, [](const auto& cell) { return pooledReliability(cell.runs).forecastCount > 0; })) {
    plots += figureOf("Does P(exists) mean what it says?", reliabilityDiagram(cells));
  }
  return plots.empty() ? plots : legendOf(cells) + "<div class='plots'>" + plots + "</div>";
}

/// One scenario in one grade; the plots of further grades are folded away.
std::string block(std::span<const SuiteCell> cells, bool folded) {
  const SuiteCell& first = cells.front();
  std::string text =
      fmt::format("<p class='soft'>{}, {} runs</p>", gradeName(first.grade), first.runs.size()) +
      scenarioTable(cells);
  if (folded) {
    return text + "<details><summary>Plots</summary>" + plotsOf(cells) + "</details>";
  }
  return text + plotsOf(cells);
}

const ScenarioDeclaration* declared(const SuiteReport& report, const std::string& name) {
  const auto found = std::ranges::find(report.catalog, name, &ScenarioDeclaration::name);
  return found == report.catalog.end() ? nullptr : &*found;
}

std::string familyOf(const SuiteReport& report, const std::string& scenario) {
  const ScenarioDeclaration* known = declared(report, scenario);
  return known != nullptr ? known->family : scenario.substr(0, scenario.find('-'));
}

std::string scenarioRows(const SuiteReport& report) {
  std::string text;
  std::string family;
  std::string scenario;
  const std::span<const SuiteCell> cells(report.cells);
  for (std::size_t begin = 0; begin < cells.size();) {
    const SuiteCell& first = cells[begin];
    std::size_t end = begin;
    while (end < cells.size() && cells[end].scenario == first.scenario &&
           cells[end].grade == first.grade) {
      ++end;
    }
    if (const std::string now = familyOf(report, first.scenario); now != family) {
      family = now;
      text +=
          fmt::format("<h2 id='{}'>{}</h2>", htmlEscaped(family), htmlEscaped(familyTitle(family)));
    }
    const bool again = first.scenario == scenario;
    if (!again) {
      scenario = first.scenario;
      const ScenarioDeclaration* known = declared(report, scenario);
      text += fmt::format("<h3>{}</h3><p>{}</p>", htmlEscaped(scenario),
                          known != nullptr ? htmlEscaped(known->description) : std::string());
    }
    text += block(cells.subspan(begin, end - begin), again);
    begin = end;
  }
  return text;
}

std::string links(const SuiteReport& report) {
  std::string text = "<nav><a href='#bars'>Requirements</a><a href='#belief'>Belief</a>"
                     "<a href='#overview'>At a glance</a>";
  std::set<std::string> done;
  for (const SuiteCell& cell : report.cells) {
    const std::string family = familyOf(report, cell.scenario);
    if (done.insert(family).second) {
      text += fmt::format("<a href='#{0}'>{0}</a>", htmlEscaped(family));
    }
  }
  return text + "<a href='#columns'>How to read it</a></nav>";
}

std::string explanation() {
  std::string text =
      "<h2 id='columns'>How to read it</h2><p>Every method sees the same frames and the same color "
      "mask. A target counts as declared when the method calls its estimate valid or P(exists) is "
      "above one half. Small gray numbers are 95 % bootstrap intervals; for percentiles over "
      "frames whole runs are resampled, because frames of one run are alike. “Never” means that "
      "it did not happen before the run ended. Medians and means are over runs. The columns of "
      "<code>runs.csv</code>, one row per run:</p><dl>";
  for (const SuiteColumn& column : suiteColumns()) {
    text += fmt::format("<dt>{}</dt><dd>{}</dd>", column.name, htmlEscaped(column.description));
  }
  return text + "</dl>";
}

} // namespace

std::string reportHtml(const SuiteReport& report) {
  return "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
         "content='width=device-width, initial-scale=1'><title>Dewpoint accuracy "
         "suite</title><style>" +
         reportStyleSheet() + "</style></head>\n<body><main>\n" + head(report) + notesOf(report) +
         links(report) + requirements(report) + belief(report) + overview(report) +
         extents(report) + scenarioRows(report) + explanation() + "\n</main></body></html>\n";
}

} // namespace dewpoint::experiment
