// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/suite_page.h"

#include "core/experiment/report/report_style.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/suite/suite_figures.h"
#include "core/experiment/suite/suite_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace dewpoint::experiment {
namespace {

/// A family's heading, where it is known.
std::string familyTitle(const std::string& family) {
  static const std::vector<std::pair<std::string, std::string>> titles{
      {"S0", "A single ball, nothing in the way"},
      {"S1", "Look-alikes of the same color"},
      {"S2", "Half of the disk hidden in one camera"},
      {"S3", "Blackouts and absences"},
      {"S4", "Random starts and jumps"},
      {"S5", "Identical targets that cross"},
      {"S6", "More cameras, and cameras that fail"},
      {"S7", "Cameras out of step"},
      {"S8", "Changing light"},
      {"S9", "A camera that was bumped"}};
  const auto found = std::ranges::find(titles, family, &std::pair<std::string, std::string>::first);
  return found == titles.end() ? family : family + " · " + found->second;
}

std::string head(const SuiteReport& report) {
  std::size_t runs = 0;
  for (const SuiteCell& cell : report.cells) {
    runs += cell.runs.size();
  }
  const bool quotable = areReportingSeeds(report.seeds);
  const std::string seeds = escaped(seedSentence(report.seeds));
  return fmt::format("<header><h1>Dewpoint accuracy suite</h1><p class='meta'>Version {} · {} runs "
                     "· seeds {}</p>{}</header>",
                     DEWPOINT_VERSION, runs, seeds,
                     quotable ? std::string()
                              : fmt::format("<p class='note'>Seeds {}. Seeds {} to {} are for "
                                            "reporting.</p>",
                                            seeds, kFirstReportingSeed, kLastReportingSeed));
}

std::string tile(const char* style, std::ptrdiff_t count, const char* words) {
  return fmt::format("<div class='tile {}'><div class='count'>{}</div>{}</div>", style, count,
                     words);
}

std::string requirements(const SuiteReport& report) {
  const auto reached = std::ranges::count_if(report.bars, &BarResult::reached);
  const auto measured = std::ranges::count_if(report.bars, &BarResult::measured);
  const auto all = static_cast<std::ptrdiff_t>(report.bars.size());
  return "<h2 id='bars'>What must be reached</h2><p>Method <b>dewpoint</b>, images of grade "
         "<b>ideal</b> (sensor noise, shading and clutter, exact calibration). The other grade, "
         "<b>room</b>, has calibration noise, lens distortion, JPEG and uneven light; it is "
         "reported and has no bar.</p><div class='tiles'>" +
         tile("good", reached, "reached") + tile("bad", measured - reached, "not reached") +
         tile("", all - measured, "not measured") + "</div>" + barTable(report.bars);
}

std::string overview(const SuiteReport& report) {
  return "<h2 id='overview'>At a glance</h2><p>Median over the runs of each run's RMSE after "
         "convergence, in millimetres; the smallest in each row is bold. Where more than a "
         "trace of the frames is lost, that is said beside it: a small error of few frames is "
         "no success.</p>" +
         overviewTable(report.cells);
}

std::string legendOf(std::span<const SuiteCell> cells) {
  std::string text = "<div class='legend'>";
  for (const SuiteCell& cell : cells) {
    text +=
        fmt::format("<span class='{}'>{}</span>", methodStyle(cell.method), escaped(cell.method));
  }
  return text + "</div>";
}

std::string figureOf(const char* caption, const Plot& plot) {
  return fmt::format("<figure><figcaption>{}</figcaption>{}</figure>", caption, svgOf(plot));
}

std::string plotsOf(std::span<const SuiteCell> cells) {
  return legendOf(cells) + "<div class='plots'>" +
         figureOf("Error over time: median, 10th to 90th percentile", errorOverTime(cells)) +
         figureOf("Share of all frames with at most this error", errorDistribution(cells)) +
         figureOf("Does P(exists) mean what it says?", reliabilityDiagram(cells)) + "</div>";
}

/// One scenario in one grade; the second grade's plots are folded away.
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
      text += fmt::format("<h2 id='{}'>{}</h2>", escaped(family), escaped(familyTitle(family)));
    }
    const bool again = first.scenario == scenario;
    if (!again) {
      scenario = first.scenario;
      const ScenarioDeclaration* known = declared(report, scenario);
      text += fmt::format("<h3>{}</h3><p>{}</p>", escaped(scenario),
                          known != nullptr ? escaped(known->sentence) : std::string());
    }
    text += block(cells.subspan(begin, end - begin), again);
    begin = end;
  }
  return text;
}

std::string links(const SuiteReport& report) {
  std::string text = "<nav><a href='#bars'>Requirements</a><a href='#overview'>At a glance</a>";
  std::set<std::string> done;
  for (const SuiteCell& cell : report.cells) {
    const std::string family = familyOf(report, cell.scenario);
    if (done.insert(family).second) {
      text += fmt::format("<a href='#{0}'>{0}</a>", escaped(family));
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
    text += fmt::format("<dt>{}</dt><dd>{}</dd>", column.name, escaped(column.sentence));
  }
  return text + "</dl>";
}

} // namespace

std::string reportHtml(const SuiteReport& report) {
  return "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
         "content='width=device-width, initial-scale=1'><title>Dewpoint accuracy "
         "suite</title><style>" +
         reportStyle() + "</style></head>\n<body><main>\n" + head(report) + links(report) +
         requirements(report) + overview(report) + scenarioRows(report) + explanation() +
         "\n</main></body></html>\n";
}

} // namespace dewpoint::experiment
