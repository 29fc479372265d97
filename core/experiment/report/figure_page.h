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

/// Whether a claim of a paper was confirmed. InPart: under some of the conditions that the paper
/// leaves open.
enum class ClaimOutcome { Reproduced, InPart, NotReproduced };

/// Outcome for the claim that nothing converges, from the converged shares of all starts tried:
/// reproduced if each is below a tenth, in part if some are.
ClaimOutcome claimOfNone(const std::vector<double>& shares);

/// Report of one experiment: a page with inline plots and with pictures in separate files, for
/// light and dark mode. Texts are plain; the page escapes them.
class FigurePage {
public:
  FigurePage(const std::string& title, const std::string& sentence);

  void heading(const std::string& text);
  void paragraph(const std::string& text);
  /// Adds a claim of the paper, and our result.
  void claim(const std::string& text, bool reproduced, const std::string& here);
  void claim(const std::string& text, ClaimOutcome outcome, const std::string& here);
  /// Adds a requirement, with a word on whether it is met; `good` determines the color.
  void bar(const std::string& word, bool good, const std::string& text);
  /// Adds plots side by side, each with its caption; `legend` names the styles.
  void plots(const std::vector<std::pair<std::string, Plot>>& plots,
             const std::vector<std::pair<std::string, std::string>>& legend = {});
  /// Adds a picture, which is written as `name`.png.
  void picture(const std::string& name, const std::string& caption, const cv::Mat& image);
  void table(const std::vector<std::string>& head,
             const std::vector<std::vector<std::string>>& rows);
  /// Adds a picture that is written as `name`.jpg: for camera images, whose noise would make large
  /// files otherwise.
  void photo(const std::string& name, const std::string& caption, const cv::Mat& image);
  /// Adds a separate file next to the page; the page names it.
  void data(const std::string& name, std::string text);

  /// The complete page.
  std::string html() const;
  /// Writes report.html and all its files; the folder is created. FileUnwritable.
  Status write(const std::filesystem::path& folder) const;

private:
  void image(const std::string& name, const std::string& format, const std::string& caption,
             const cv::Mat& image);

  std::string title_;
  std::string body_;
  std::vector<std::pair<std::string, std::string>> files_; ///< name, bytes
};

/// Parts of such pages, as HTML.
std::string plotsHtml(const std::vector<std::pair<std::string, Plot>>& plots,
                      const std::vector<std::pair<std::string, std::string>>& legend);
std::string pictureHtml(const std::string& file, const std::string& caption);
/// Bytes of an image file; `format` is ".png" or ".jpg".
std::string imageFile(const cv::Mat& image, const std::string& format);

/// Columns of numbers as CSV, below their names.
std::string numbersAsCsv(const std::vector<std::string>& names,
                         const std::vector<std::vector<double>>& columns);

} // namespace dewpoint::experiment
