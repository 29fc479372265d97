// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/report/figure_page.h"

#include "core/base/markup.h"
#include "core/base/text_file.h"
#include "core/experiment/report/report_folder.h"
#include "core/experiment/report/report_style.h"

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace dewpoint::experiment {
namespace {

std::string rowOf(const std::vector<std::string>& cells, const char* tag) {
  std::string text = "<tr>";
  for (const std::string& cell : cells) {
    text += fmt::format("<{0}>{1}</{0}>", tag, htmlEscaped(cell));
  }
  return text + "</tr>";
}

} // namespace

ClaimOutcome outcomeOfNoConvergenceClaim(const std::vector<double>& shares) {
  constexpr double kNone = 0.1;
  const auto none = std::ranges::count_if(shares, [](double share) { return share < kNone; });
  return none == 0                    ? ClaimOutcome::NotReproduced
         : none == std::ssize(shares) ? ClaimOutcome::Reproduced
                                      : ClaimOutcome::InPart;
}

FigurePage::FigurePage(const std::string& title, const std::string& sentence)
    : title_(title),
      body_(fmt::format("<header><h1>{}</h1><p class='meta'>Dewpoint {}</p></header>"
                        "<p>{}</p>",
                        htmlEscaped(title), DEWPOINT_VERSION, htmlEscaped(sentence))) {}

void FigurePage::addHeading(const std::string& text) {
  body_ += fmt::format("<h2>{}</h2>", htmlEscaped(text));
}

void FigurePage::addParagraph(const std::string& text) {
  body_ += fmt::format("<p>{}</p>", htmlEscaped(text));
}

void FigurePage::addClaim(const std::string& text, bool reproduced, const std::string& here) {
  addClaim(text, reproduced ? ClaimOutcome::Reproduced : ClaimOutcome::NotReproduced, here);
}

void FigurePage::addClaim(const std::string& text, ClaimOutcome outcome, const std::string& here) {
  const char* style = outcome == ClaimOutcome::Reproduced ? "good"
                      : outcome == ClaimOutcome::InPart   ? "part"
                                                          : "bad";
  const char* word = outcome == ClaimOutcome::Reproduced ? "reproduced"
                     : outcome == ClaimOutcome::InPart   ? "reproduced in part"
                                                         : "not reproduced";
  body_ += fmt::format("<p><span class='chip {}'>{}</span> <b>{}</b> {}</p>", style, word,
                       htmlEscaped(text), htmlEscaped(here));
}

void FigurePage::addRequirement(const std::string& word, bool good, const std::string& text) {
  body_ += fmt::format("<p><span class='chip {}'>{}</span> {}</p>", good ? "good" : "bad",
                       htmlEscaped(word), htmlEscaped(text));
}

void FigurePage::addPlots(const std::vector<std::pair<std::string, Plot>>& plots,
                          const std::vector<std::pair<std::string, std::string>>& legend) {
  body_ += plotsHtml(plots, legend);
}

void FigurePage::addPngImage(const std::string& name, const std::string& caption,
                             const cv::Mat& image) {
  addImage(name, ".png", caption, image);
}

void FigurePage::addJpegImage(const std::string& name, const std::string& caption,
                              const cv::Mat& image) {
  addImage(name, ".jpg", caption, image);
}

void FigurePage::addImage(const std::string& name, const std::string& format,
                          const std::string& caption, const cv::Mat& image) {
  files_.emplace_back(name + format, encodeImage(image, format));
  body_ += imageHtml(name + format, caption);
}

void FigurePage::addTable(const std::vector<std::string>& head,
                          const std::vector<std::vector<std::string>>& rows) {
  body_ += "<div class='scroll'><table><thead>" + rowOf(head, "th") + "</thead><tbody>";
  for (const auto& row : rows) {
    body_ += rowOf(row, "td");
  }
  body_ += "</tbody></table></div>";
}

void FigurePage::addDataFile(const std::string& name, std::string text) {
  body_ += fmt::format("<p class='soft'>The numbers: <a href='{0}'>{0}</a></p>", name);
  files_.emplace_back(name, std::move(text));
}

std::string FigurePage::html() const {
  return fmt::format("<!DOCTYPE html><html lang='en'><head><meta charset='utf-8'><title>{}</title>"
                     "<style>{}</style></head><body><main>{}</main></body></html>\n",
                     htmlEscaped(title_), reportStyleSheet(), body_);
}

Status FigurePage::write(const std::filesystem::path& folder) const {
  if (const auto prepared = prepareReportFolder(folder); !prepared) {
    return prepared;
  }
  for (const auto& [name, bytes] : files_) {
    if (auto written = writeTextFile(folder / name, bytes); !written) {
      return written;
    }
  }
  return writeTextFile(folder / "report.html", html());
}

std::string plotsHtml(const std::vector<std::pair<std::string, Plot>>& plots,
                      const std::vector<std::pair<std::string, std::string>>& legend) {
  std::string text;
  if (!legend.empty()) {
    text += "<div class='legend'>";
    for (const auto& [style, name] : legend) {
      text += fmt::format("<span class='{}'>{}</span>", style, htmlEscaped(name));
    }
    text += "</div>";
  }
  text += "<div class='plots'>";
  for (const auto& [caption, plot] : plots) {
    text += fmt::format("<figure><figcaption>{}</figcaption>{}</figure>", htmlEscaped(caption),
                        renderSvg(plot));
  }
  return text + "</div>";
}

std::string imageHtml(const std::string& file, const std::string& caption) {
  return fmt::format("<figure><figcaption>{0}</figcaption><img src='{1}' alt='{0}' "
                     "style='max-width:100%'></figure>",
                     htmlEscaped(caption), htmlEscaped(file));
}

std::string encodeImage(const cv::Mat& image, const std::string& format) {
  constexpr int kJpegQuality = 88;
  std::vector<std::uint8_t> bytes;
  cv::imencode(format, image, bytes,
               format == ".jpg" ? std::vector<int>{cv::IMWRITE_JPEG_QUALITY, kJpegQuality}
                                : std::vector<int>{});
  return {bytes.begin(), bytes.end()};
}

std::string numbersAsCsv(const std::vector<std::string>& names,
                         const std::vector<std::vector<double>>& columns) {
  std::string text = fmt::format("{}\n", fmt::join(names, ","));
  std::size_t rows = 0;
  for (const auto& column : columns) {
    rows = std::max(rows, column.size());
  }
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      text += k > 0 ? "," : "";
      text += row < columns[k].size() ? fmt::format("{}", columns[k][row]) : "";
    }
    text += "\n";
  }
  return text;
}

} // namespace dewpoint::experiment
