// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/report/svg_plot.h"

#include <opencv2/core/mat.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::experiment {

/// Whether a claim of a paper came out here; InPart: under some of the conditions that the paper
/// leaves open.
enum class ClaimOutcome { Reproduced, InPart, NotReproduced };

/// Of a claim that nothing converges, from the shares that do from all starts tried: reproduced
/// when each is below a tenth, in part when some are.
ClaimOutcome claimOfNone(const std::vector<double>& shares);

/// The report of one experiment: a page with its plots inline and its pictures beside it, light and
/// dark. Texts are plain; they are escaped here.
class FigurePage {
public:
  FigurePage(const std::string& title, const std::string& sentence);

  void heading(const std::string& text);
  void paragraph(const std::string& text);
  /// A claim of the paper, and what came out here.
  void claim(const std::string& text, bool reproduced, const std::string& here);
  void claim(const std::string& text, ClaimOutcome outcome, const std::string& here);
  /// A requirement, with a word on whether it is met; `good` gives the color.
  void bar(const std::string& word, bool good, const std::string& text);
  /// Plots beside each other, each with its caption; `legend` names the styles.
  void plots(const std::vector<std::pair<std::string, Plot>>& plots,
             const std::vector<std::pair<std::string, std::string>>& legend = {});
  /// A picture that is written as `name`.png.
  void picture(const std::string& name, const std::string& caption, const cv::Mat& image);
  void table(const std::vector<std::string>& head,
             const std::vector<std::vector<std::string>>& rows);
  /// The same as `name`.jpg: for images of cameras, whose noise makes large files otherwise.
  void photo(const std::string& name, const std::string& caption, const cv::Mat& image);
  /// A file of its own beside the page, named in it.
  void data(const std::string& name, std::string text);

  /// The page.
  std::string html() const;
  /// Writes report.html and everything beside it; the folder is made. FileUnwritable.
  Status write(const std::filesystem::path& folder) const;

private:
  void image(const std::string& name, const std::string& format, const std::string& caption,
             const cv::Mat& image);

  std::string title_;
  std::string body_;
  std::vector<std::pair<std::string, std::string>> files_; ///< name, bytes
};

/// The parts of which such pages are made, as HTML.
std::string plotsHtml(const std::vector<std::pair<std::string, Plot>>& plots,
                      const std::vector<std::pair<std::string, std::string>>& legend);
std::string pictureHtml(const std::string& file, const std::string& caption);
/// The bytes of an image file; `format` is ".png" or ".jpg".
std::string imageFile(const cv::Mat& image, const std::string& format);

/// Lines of comma-separated numbers under their names.
std::string numbersAsCsv(const std::vector<std::string>& names,
                         const std::vector<std::vector<double>>& columns);

} // namespace dewpoint::experiment
