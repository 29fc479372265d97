// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/figure_page.h"

#include "core/base/markup.h"
#include "core/base/text_file.h"
#include "core/experiment/suite_report.h"

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <cstdint>

namespace dewpoint {
namespace {

std::string rowOf(const std::vector<std::string>& cells, const char* tag) {
  std::string text = "<tr>";
  for (const std::string& cell : cells) {
    text += fmt::format("<{0}>{1}</{0}>", tag, escaped(cell));
  }
  return text + "</tr>";
}

} // namespace

FigurePage::FigurePage(const std::string& title, const std::string& sentence)
    : title_(title), body_(fmt::format("<header><h1>{}</h1><p class='meta'>Dewpoint {}</p></header>"
                                       "<p>{}</p>",
                                       escaped(title), DEWPOINT_VERSION, escaped(sentence))) {}

void FigurePage::heading(const std::string& text) {
  body_ += fmt::format("<h2>{}</h2>", escaped(text));
}

void FigurePage::paragraph(const std::string& text) {
  body_ += fmt::format("<p>{}</p>", escaped(text));
}

void FigurePage::claim(const std::string& text, bool reproduced, const std::string& here) {
  body_ += fmt::format("<p><span class='chip {}'>{}</span> <b>{}</b> {}</p>",
                       reproduced ? "good" : "bad", reproduced ? "reproduced" : "not reproduced",
                       escaped(text), escaped(here));
}

void FigurePage::plots(const std::vector<std::pair<std::string, Plot>>& plots,
                       const std::vector<std::pair<std::string, std::string>>& legend) {
  if (!legend.empty()) {
    body_ += "<div class='legend'>";
    for (const auto& [style, text] : legend) {
      body_ += fmt::format("<span class='{}'>{}</span>", style, escaped(text));
    }
    body_ += "</div>";
  }
  body_ += "<div class='plots'>";
  for (const auto& [caption, plot] : plots) {
    body_ += fmt::format("<figure><figcaption>{}</figcaption>{}</figure>", escaped(caption),
                         svgOf(plot));
  }
  body_ += "</div>";
}

void FigurePage::picture(const std::string& name, const std::string& caption,
                         const cv::Mat& image) {
  std::vector<std::uint8_t> png;
  cv::imencode(".png", image, png);
  files_.emplace_back(name + ".png", std::string(png.begin(), png.end()));
  body_ += fmt::format("<figure><figcaption>{}</figcaption><img src='{}.png' alt='{}' "
                       "style='max-width:100%'></figure>",
                       escaped(caption), name, escaped(caption));
}

void FigurePage::table(const std::vector<std::string>& head,
                       const std::vector<std::vector<std::string>>& rows) {
  body_ += "<div class='scroll'><table><thead>" + rowOf(head, "th") + "</thead><tbody>";
  for (const auto& row : rows) {
    body_ += rowOf(row, "td");
  }
  body_ += "</tbody></table></div>";
}

void FigurePage::data(const std::string& name, std::string text) {
  body_ += fmt::format("<p class='soft'>The numbers: <a href='{0}'>{0}</a></p>", name);
  files_.emplace_back(name, std::move(text));
}

Status FigurePage::write(const std::filesystem::path& folder) const {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) {
    return failure(ErrorCode::FileUnwritable, folder.string(), "", problem.message());
  }
  const std::string page =
      fmt::format("<!DOCTYPE html><html lang='en'><head><meta charset='utf-8'><title>{}</title>"
                  "<style>{}</style></head><body><main>{}</main></body></html>\n",
                  escaped(title_), reportStyle(), body_);
  for (const auto& [name, bytes] : files_) {
    if (auto written = writeTextFile(folder / name, bytes); !written) {
      return written;
    }
  }
  return writeTextFile(folder / "report.html", page);
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

} // namespace dewpoint
