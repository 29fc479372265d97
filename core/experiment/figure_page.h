// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/suite_plot.h"

#include <opencv2/core/mat.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint {

/// The report of one experiment: a page with its plots inline and its pictures beside it, light and
/// dark. Texts are plain; they are escaped here.
class FigurePage {
public:
  FigurePage(const std::string& title, const std::string& sentence);

  void heading(const std::string& text);
  void paragraph(const std::string& text);
  /// A claim of the paper, and what came out here.
  void claim(const std::string& text, bool reproduced, const std::string& here);
  /// Plots beside each other, each with its caption; `legend` names the styles.
  void plots(const std::vector<std::pair<std::string, Plot>>& plots,
             const std::vector<std::pair<std::string, std::string>>& legend = {});
  /// A picture that is written as `name`.png.
  void picture(const std::string& name, const std::string& caption, const cv::Mat& image);
  void table(const std::vector<std::string>& head,
             const std::vector<std::vector<std::string>>& rows);
  /// A file of its own beside the page, named in it.
  void data(const std::string& name, std::string text);

  /// Writes report.html and everything beside it; the folder is made. FileUnwritable.
  Status write(const std::filesystem::path& folder) const;

private:
  std::string title_;
  std::string body_;
  std::vector<std::pair<std::string, std::string>> files_; ///< name, bytes
};

/// Lines of comma-separated numbers under their names.
std::string numbersAsCsv(const std::vector<std::string>& names,
                         const std::vector<std::vector<double>>& columns);

} // namespace dewpoint
