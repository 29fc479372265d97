// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/sugandi_report.h"

#include "core/base/markup.h"
#include "core/base/text_file.h"
#include "core/base/units.h"
#include "core/experiment/report/figure_page.h"
#include "core/experiment/report/report_style.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/studies/sugandi_pictures.h"
#include "core/experiment/studies/sugandi_study.h"
#include "core/trajectory/csv_text.h"

#include <fmt/format.h>

#include <utility>

namespace dewpoint::experiment {
namespace {

constexpr const char* kRemarks[] = {
    "RMSE: of the centers, over all frames after the first, px. Success: area under the curve of "
    "the share of frames whose overlap is above a threshold. Precision: share of frames with the "
    "center "
    "within the radius (20 px on otb, else the ball's).",
    "All methods start from the true box of the first frame. The results of sugandi and histogram "
    "are means over the seeds. OpenCV's trackers use their default parameters, with which KCF soon "
    "loses the target.",
    "A star marks clips whose ground truth has only centers, with boxes of a fixed size: their "
    "success means little.",
    "The paper's clip is not public: its RMSE of 6.48 px with 100 particles and 2.28 px with 300 "
    "cannot be reproduced, only the trend. The paper states neither the motion noise nor sigma.",
    "Curves, frames and histograms are of the first seed; tracks.csv and histograms.csv have their "
    "numbers. Bins are numbered 64 r + 8 g + b, with r, g and b from 0 to 7."};

std::string seedRemark(const BoxStudy& study) {
  return "Seeds of Dewpoint's methods: " + describeSeeds(study.firstSeed, study.seedCount) + ".";
}

std::string starred(const BoxStudyRow& row) {
  return row.clip + (row.hasExactBoxes ? "" : " *");
}

std::string tableHead() {
  return "<div class='scroll'><table><thead><tr><th>method</th><th>seeds</th><th>RMSE px</th>"
         "<th>success</th><th>precision</th><th>worst seed</th><th>ms per frame</th></tr></thead>"
         "<tbody>";
}

std::string tableRow(const BoxStudyRow& row) {
  return fmt::format("<tr{}><td>{}</td><td>{}</td><td>{:.2f}</td><td>{:.3f}</td><td>{:.1f} %</td>"
                     "<td>{:.1f} %</td><td>{:.2f}</td></tr>",
                     row.isDewpointMethod ? " class='ours'" : "", htmlEscaped(row.method),
                     row.seedCount, row.metrics.rmse, row.metrics.success,
                     inPercent(row.metrics.precision), inPercent(row.worstPrecision),
                     row.millisecondsPerFrame);
}

/// The table of a clip and its figures.
std::string clipHtml(const BoxStudy& study, std::size_t clip) {
  std::string rows;
  std::string title;
  for (const BoxStudyRow& row : study.rows) {
    if (row.clip == study.figures[clip].clip) {
      title = starred(row);
      rows += tableRow(row);
    }
  }
  return fmt::format("<h2>{}</h2>{}{}</tbody></table></div>{}", htmlEscaped(title), tableHead(),
                     rows, boxHistogramsHtml(study, clip) + boxFiguresHtml(study, clip));
}

std::string barsHtml(const BoxStudy& study) {
  std::string text = "<h2>What must be reached</h2><div class='scroll'><table><tbody>";
  for (const BoxRequirement& bar : study.requirements) {
    text += fmt::format("<tr><td class='text'>{}</td><td><span class='chip {}'>{}</span></td></tr>",
                        htmlEscaped(bar.description), bar.isMet ? "good" : "bad",
                        bar.isMet ? "reached" : "not reached");
  }
  return text + "</tbody></table></div>";
}

constexpr const char* kPerturbationRemark =
    "Imprecise first boxes: 0.8 to 1.4 times the true size, each at the true position and shifted "
    "by "
    "15 % to the four sides. They are compared with the true boxes, so that success decreases with "
    "the overlap of the first box. Similarity on and off the target (center within the radius or "
    "not): means of the similarity that a method reports; frames in which it reports the target "
    "hidden count as 0. Confident but wrong: share of all frames off the target with a similarity "
    "above 0.9.";

std::string claimsText(const BoxPerturbationRow& row) {
  return row.reportsConfidence
             ? fmt::format("{:>6.2f} {:>6.2f} {:>6.1f} %", row.similarityOnTarget,
                           row.similarityOffTarget, inPercent(row.confidentlyWrongShare))
             : std::string();
}

std::string perturbationText(const std::vector<BoxPerturbationRow>& rows) {
  std::string text = fmt::format("\nImprecise first boxes\n{:<28} {:<10} {:>5} {:>5} {:>8} {:>8} "
                                 "{:>9} {:>8} {:>6} {:>6} {:>8}\n",
                                 "clip", "method", "size", "runs", "RMSE px", "success",
                                 "precision", "worst", "on", "off", "wrong");
  for (const BoxPerturbationRow& row : rows) {
    text += fmt::format("{:<28} {:<10} {:>5.1f} {:>5} {:>8.2f} {:>8.3f} {:>7.1f} % {:>6.1f} % {}\n",
                        row.clip, row.method, row.scale, row.runCount, row.metrics.rmse,
                        row.metrics.success, inPercent(row.metrics.precision),
                        inPercent(row.worstPrecision), claimsText(row));
  }
  return text + fmt::format("{}\n", kPerturbationRemark);
}

std::string claimsCells(const BoxPerturbationRow& row) {
  return row.reportsConfidence ? fmt::format("<td>{:.2f}</td><td>{:.2f}</td><td>{:.1f} %</td>",
                                             row.similarityOnTarget, row.similarityOffTarget,
                                             inPercent(row.confidentlyWrongShare))
                               : "<td></td><td></td><td></td>";
}

std::string perturbationHtml(const std::vector<BoxPerturbationRow>& rows) {
  std::string text =
      "<h2>Imprecise first boxes</h2><div "
      "class='scroll'><table><thead><tr><th>clip</th><th>method</th><th>size</th><th>runs</"
      "th><th>RMSE px</th><th>success</th><th>precision</th><th>worst run</th><th>similarity "
      "on</th><th>off</th><th>confident but wrong</th></tr></thead><tbody>";
  for (const BoxPerturbationRow& row : rows) {
    text += fmt::format("<tr{}><td>{}</td><td>{}</td><td>{:.1f}</td><td>{}</td><td>{:.2f}</td>"
                        "<td>{:.3f}</td><td>{:.1f} %</td><td>{:.1f} %</td>{}</tr>",
                        row.reportsConfidence ? " class='ours'" : "", htmlEscaped(row.clip),
                        htmlEscaped(row.method), row.scale, row.runCount, row.metrics.rmse,
                        row.metrics.success, inPercent(row.metrics.precision),
                        inPercent(row.worstPrecision), claimsCells(row));
  }
  return text + fmt::format("</tbody></table></div><p>{}</p>", htmlEscaped(kPerturbationRemark));
}

} // namespace

std::string perturbedBoxesCsv(const std::vector<BoxPerturbationRow>& rows) {
  std::string text = "clip,method,size,runs,rmse_px,success,precision,worst_precision,"
                     "similarity_on,similarity_off,surely_wrong\n";
  for (const BoxPerturbationRow& row : rows) {
    text += fmt::format("{},{},{},{},{},{},{},{}", csvCell(row.clip), csvCell(row.method),
                        row.scale, row.runCount, row.metrics.rmse, row.metrics.success,
                        row.metrics.precision, row.worstPrecision);
    text += row.reportsConfidence ? fmt::format(",{},{},{}\n", row.similarityOnTarget,
                                                row.similarityOffTarget, row.confidentlyWrongShare)
                                  : ",,,\n";
  }
  return text;
}

std::string boxStudyText(const BoxStudy& study) {
  std::string text =
      fmt::format("{:<26} {:<25} {:>5} {:>8} {:>8} {:>9} {:>8} {:>8}\n", "clip", "method", "seeds",
                  "RMSE px", "success", "precision", "worst", "ms");
  for (const BoxStudyRow& row : study.rows) {
    text += fmt::format("{:<26} {:<25} {:>5} {:>8.2f} {:>8.3f} {:>7.1f} % {:>6.1f} % {:>8.2f}\n",
                        starred(row), row.method, row.seedCount, row.metrics.rmse,
                        row.metrics.success, inPercent(row.metrics.precision),
                        inPercent(row.worstPrecision), row.millisecondsPerFrame);
  }
  text += '\n';
  for (const BoxRequirement& bar : study.requirements) {
    text += fmt::format("{:<12} {}\n", bar.isMet ? "reached" : "NOT REACHED", bar.description);
  }
  text += '\n';
  for (const char* remark : kRemarks) {
    text += fmt::format("{}\n", remark);
  }
  text += fmt::format("{}\n", seedRemark(study));
  return study.perturbedRows.empty() ? text : text + perturbationText(study.perturbedRows);
}

std::string boxStudyCsv(const BoxStudy& study) {
  std::string text = "clip,method,seeds,rmse_px,success,precision,worst_precision,ms_per_frame\n";
  for (const BoxStudyRow& row : study.rows) {
    text += fmt::format("{},{},{},{},{},{},{},{}\n", csvCell(row.clip), csvCell(row.method),
                        row.seedCount, row.metrics.rmse, row.metrics.success, row.metrics.precision,
                        row.worstPrecision, row.millisecondsPerFrame);
  }
  return text;
}

std::string boxStudyHtml(const BoxStudy& study) {
  std::string text = "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta "
                     "name='viewport' content='width=device-width, initial-scale=1'><title>Color "
                     "histograms in one camera</title><style>" +
                     reportStyleSheet() +
                     "</style></head>\n<body><main>\n<h1>Color histograms in one camera</h1><p "
                     "class='meta'>Experiment sugandi-rmse, version " DEWPOINT_VERSION "</p>" +
                     barsHtml(study);
  for (std::size_t clip = 0; clip < study.figures.size(); ++clip) {
    text += clipHtml(study, clip);
  }
  text += study.perturbedRows.empty() ? "" : perturbationHtml(study.perturbedRows);
  text += "<h2>How to read it</h2>";
  for (const char* remark : kRemarks) {
    text += fmt::format("<p>{}</p>", htmlEscaped(remark));
  }
  text += fmt::format("<p>{}</p>", htmlEscaped(seedRemark(study)));
  return text + "\n</main></body></html>\n";
}

Status writeBoxStudy(const BoxStudy& study, const std::filesystem::path& folder) {
  std::vector<std::pair<std::string, std::string>> files{
      {"sugandi-rmse.txt", boxStudyText(study)},
      {"sugandi-rmse.csv", boxStudyCsv(study)},
      {"tracks.csv", boxTracksCsv(study)},
      {"histograms.csv", boxHistogramsCsv(study)}};
  for (std::size_t clip = 0; clip < study.figures.size(); ++clip) {
    files.emplace_back(framesWithBoxesFileName(clip),
                       encodeImage(study.figures[clip].framesImage, ".jpg"));
  }
  if (!study.perturbedRows.empty()) {
    files.emplace_back("sloppy-boxes.csv", perturbedBoxesCsv(study.perturbedRows));
  }
  files.emplace_back(kBoxReport, boxStudyHtml(study));
  for (const auto& [name, bytes] : files) {
    if (auto written = writeTextFile(folder / name, bytes); !written) {
      return written;
    }
  }
  return {};
}

} // namespace dewpoint::experiment
