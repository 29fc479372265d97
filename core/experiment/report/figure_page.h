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

/// Result of checking a claim of a paper. InPart means that the claim holds only under some of the
/// conditions that the paper leaves open.
enum class ClaimOutcome { Reproduced, InPart, NotReproduced };

/// Returns the outcome for the claim of a paper that no run converges. `shares` contains, for each
/// initial position of the particles, the fraction of runs that converged. The claim is reproduced
/// if every fraction is below one tenth, and reproduced in part if some fractions are.
ClaimOutcome outcomeOfNoConvergenceClaim(const std::vector<double>& shares);

/// Report of one experiment: a page with inline plots and separate image files, for light and dark
/// mode. Text arguments are plain text; the page escapes them.
class FigurePage {
public:
  /// Creates a page with a title and an introductory sentence.
  FigurePage(const std::string& title, const std::string& sentence);

  /// Adds a section heading.
  void addHeading(const std::string& text);
  /// Adds a paragraph of text.
  void addParagraph(const std::string& text);
  /// Adds a claim of a paper (`text`), whether this experiment reproduces it, and the result of
  /// this experiment (`here`).
  void addClaim(const std::string& text, bool reproduced, const std::string& here);
  void addClaim(const std::string& text, ClaimOutcome outcome, const std::string& here);
  /// Adds a requirement. `word` states whether the requirement is met, and `good` determines the
  /// color of this word.
  void addRequirement(const std::string& word, bool good, const std::string& text);
  /// Adds plots side by side, each with a caption. Each entry of `legend` is a style and the name
  /// that is shown for it.
  void addPlots(const std::vector<std::pair<std::string, Plot>>& plots,
                const std::vector<std::pair<std::string, std::string>>& legend = {});
  /// Adds an image, which write() saves as `name`.png.
  void addPngImage(const std::string& name, const std::string& caption, const cv::Mat& image);
  /// Adds a table with column headers `head`.
  void addTable(const std::vector<std::string>& head,
                const std::vector<std::vector<std::string>>& rows);
  /// Adds an image, which write() saves as `name`.jpg. Use this for camera images, because their
  /// noise makes PNG files large.
  void addJpegImage(const std::string& name, const std::string& caption, const cv::Mat& image);
  /// Adds a file that write() creates next to the page. The page mentions the name of the file.
  void addDataFile(const std::string& name, std::string text);

  /// Returns the complete page as HTML.
  std::string html() const;
  /// Writes report.html and all its files into a folder, which is created. Error: FileUnwritable.
  Status write(const std::filesystem::path& folder) const;

private:
  void addImage(const std::string& name, const std::string& format, const std::string& caption,
                const cv::Mat& image);

  std::string title_;
  std::string body_;
  std::vector<std::pair<std::string, std::string>> files_; ///< name, bytes
};

/// Return HTML for a report page: plots with their captions and legend, or an image with its
/// caption.
std::string plotsHtml(const std::vector<std::pair<std::string, Plot>>& plots,
                      const std::vector<std::pair<std::string, std::string>>& legend);
std::string imageHtml(const std::string& file, const std::string& caption);
/// Encodes an image and returns the bytes of the file. `format` is ".png" or ".jpg".
std::string encodeImage(const cv::Mat& image, const std::string& format);

/// Formats columns of numbers as CSV, with their names in the first line.
std::string numbersAsCsv(const std::vector<std::string>& names,
                         const std::vector<std::vector<double>>& columns);

} // namespace dewpoint::experiment
