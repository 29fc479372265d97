// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/sugandi_pictures.h"

#include "core/experiment/report/figure_page.h"
#include "core/observation/boxes/histogram_similarity.h"
#include "core/trajectory/csv_text.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace dewpoint::experiment {
namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
constexpr int kCellWidth = 240; ///< pixels, of one picture

/// What is drawn over the frames, and in which style.
struct Shown {
  const char* method;
  const char* style;
};
constexpr std::array kShown{Shown{kSugandiFew, "m1"}, Shown{kSugandiMany, "m0"},
                            Shown{kHistogram, "m2"}};

using Found = std::vector<std::optional<ImageBox>>;

double errorAt(const Found& found, const std::vector<ImageBox>& truth, std::size_t frame) {
  return found[frame] ? (found[frame]->center() - truth[frame].center()).norm() : kGap;
}

std::vector<std::size_t> tellingFrames(const Found& found, const std::vector<ImageBox>& truth) {
  constexpr std::size_t kEven = 4; // frames, evenly over the clip
  std::vector<std::size_t> frames;
  for (std::size_t k = 1; k <= kEven; ++k) {
    frames.push_back(k * (truth.size() - 1) / kEven);
  }
  std::size_t worst = 0;
  for (std::size_t frame = 0; frame < truth.size(); ++frame) {
    worst = errorAt(found, truth, frame) > errorAt(found, truth, worst) ? frame : worst;
  }
  frames.push_back(worst);
  std::ranges::sort(frames);
  return frames;
}

void drawBox(const ImageBox& box, double scale, const cv::Scalar& color, int thickness,
             cv::Mat& image) {
  cv::rectangle(image,
                cv::Rect(cvRound(scale * box.x), cvRound(scale * box.y), cvRound(scale * box.width),
                         cvRound(scale * box.height)),
                color, thickness, cv::LINE_AA);
}

cv::Mat cellOf(const cv::Mat& image, std::size_t frame, const ImageBox& truth,
               const std::optional<ImageBox>& found) {
  const cv::Scalar red(40, 40, 235);
  const double scale = double(kCellWidth) / image.cols;
  cv::Mat cell;
  cv::resize(image, cell, {}, scale, scale, scale < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
  drawBox(truth, scale, {255, 255, 255}, 1, cell);
  if (found) {
    drawBox(*found, scale, red, 2, cell);
    const Eigen::Vector2d center = scale * found->center();
    cv::circle(cell, {cvRound(center.x()), cvRound(center.y())}, 4, red, 1, cv::LINE_AA);
  }
  const std::string text = fmt::format("frame {}{}", frame, found ? "" : ": given up");
  cv::putText(cell, text, {6, 14}, cv::FONT_HERSHEY_SIMPLEX, 0.4, {0, 0, 0}, 3, cv::LINE_AA);
  cv::putText(cell, text, {6, 14}, cv::FONT_HERSHEY_SIMPLEX, 0.4, {255, 255, 255}, 1, cv::LINE_AA);
  return cell;
}

/// A number of each frame, as a line.
SvgSeries lineOf(const char* style, std::size_t frames,
                 const std::function<double(std::size_t)>& value) {
  SvgSeries series;
  series.style = style;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    series.points.push_back({double(frame), value(frame)});
  }
  return series;
}

/// Axes within which all lines lie.
Plot plotOf(const std::string& title, const std::string& unit, std::vector<SvgSeries> series,
            bool fromZero) {
  Plot plot;
  plot.title = title;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const SvgSeries& one : series) {
    for (const SvgPoint& point : one.points) {
      low = std::isnan(point.y) ? low : std::min(low, point.y);
      high = std::isnan(point.y) ? high : std::max(high, point.y);
    }
  }
  const double margin = 0.05 * std::max(1.0, high - low);
  plot.x = {"frame", 0.0, std::max(1.0, double(series.front().points.size()) - 1.0), false};
  plot.y = {unit, fromZero ? 0.0 : low - margin, high + margin, false};
  plot.series = std::move(series);
  return plot;
}

const BoxStudyRow* rowOf(const BoxStudy& study, const std::string& clip, const char* method) {
  const auto found = std::ranges::find_if(
      study.rows, [&](const BoxStudyRow& row) { return row.clip == clip && row.method == method; });
  return found == study.rows.end() ? nullptr : &*found;
}

} // namespace

cv::Mat drawBoxFrames(const std::vector<cv::Mat>& images, const std::vector<ImageBox>& truth,
                      const BoxStudyRow& few, const BoxStudyRow& many) {
  std::vector<cv::Mat> lines;
  const auto frames = tellingFrames(few.boxes, truth);
  for (const BoxStudyRow* row : {&few, &many}) {
    std::vector<cv::Mat> cells;
    cells.reserve(frames.size());
    for (const std::size_t frame : frames) {
      cells.push_back(cellOf(images[frame], frame, truth[frame], row->boxes[frame]));
    }
    cv::hconcat(cells, lines.emplace_back());
  }
  cv::Mat page;
  cv::vconcat(lines, page);
  return page;
}

std::string framesWithBoxesFileName(std::size_t clip) {
  return fmt::format("clip-{}.jpg", clip + 1);
}

std::string boxFiguresHtml(const BoxStudy& study, std::size_t clip) {
  const BoxClipFigures& figures = study.figures[clip];
  const std::size_t count = figures.truth.size();
  const auto truthLine = [&](int axis) {
    return lineOf("m5", count,
                  [&, axis](std::size_t k) { return figures.truth[k].center()[axis]; });
  };
  std::array<std::vector<SvgSeries>, 2> centers{std::vector{truthLine(0)},
                                                std::vector{truthLine(1)}};
  std::vector<SvgSeries> errors;
  std::vector<std::pair<std::string, std::string>> legend{{"m5", "truth"}};
  for (const Shown& shown : kShown) {
    const BoxStudyRow* row = rowOf(study, figures.clip, shown.method);
    if (row == nullptr) {
      continue;
    }
    legend.emplace_back(shown.style, shown.method);
    for (int axis = 0; axis < 2; ++axis) {
      centers.at(std::size_t(axis)).push_back(lineOf(shown.style, count, [&](std::size_t k) {
        return row->boxes[k] ? row->boxes[k]->center()[axis] : kGap;
      }));
    }
    errors.push_back(lineOf(shown.style, count,
                            [&](std::size_t k) { return errorAt(row->boxes, figures.truth, k); }));
  }
  return plotsHtml({{"x of the center", plotOf("x over frames", "x, px", centers[0], false)},
                    {"y of the center", plotOf("y over frames", "y, px", centers[1], false)},
                    {"Distance to the true center",
                     plotOf("error over frames", "error, px", errors, true)}},
                   legend) +
         imageHtml(framesWithBoxesFileName(clip),
                   figures.clip + ": sugandi with 100 particles (above) and with 300 (below), "
                                  "red: box and center as found, white: true box; four frames "
                                  "evenly picked and the one where 100 particles are farthest "
                                  "off");
}

std::string boxHistogramsHtml(const BoxStudy& study, std::size_t clip) {
  const BoxClipFigures& figures = study.figures[clip];
  if (figures.referenceHistogram.empty() || figures.candidateHistogram.empty()) {
    return {};
  }
  const double highest = std::max(std::ranges::max(figures.referenceHistogram),
                                  std::ranges::max(figures.candidateHistogram));
  const auto histogramPlot = [&](const char* title, const std::vector<double>& shares) {
    Plot plot;
    plot.title = title;
    plot.x = {"bin", 0.0, double(shares.size() - 1), false};
    plot.y = {"share", 0.0, 1.05 * highest, false};
    plot.series.push_back(lineOf("m0", shares.size(), [&](std::size_t k) { return shares[k]; }));
    return plot;
  };
  const double similarity =
      bhattacharyyaCoefficient(figures.candidateHistogram, figures.referenceHistogram);
  return plotsHtml(
      {{"Reference: the colors of the given box, frame 0",
        histogramPlot("reference histogram", figures.referenceHistogram)},
       {fmt::format("Candidate: those of the box found with 300 particles, frame {}; similarity "
                    "{:.3f}",
                    figures.candidateFrame, similarity),
        histogramPlot("candidate histogram", figures.candidateHistogram)}},
      {});
}

std::string boxHistogramsCsv(const BoxStudy& study) {
  std::string text = "clip,frame,bin,reference,candidate\n";
  for (const BoxClipFigures& figures : study.figures) {
    const std::size_t bins =
        figures.referenceHistogram.empty() ? 0 : figures.candidateHistogram.size();
    for (std::size_t bin = 0; bin < bins; ++bin) {
      if (figures.referenceHistogram[bin] > 0.0 || figures.candidateHistogram[bin] > 0.0) {
        text += fmt::format("{},{},{},{},{}\n", csvCell(figures.clip), figures.candidateFrame, bin,
                            figures.referenceHistogram[bin], figures.candidateHistogram[bin]);
      }
    }
  }
  return text;
}

std::string boxTracksCsv(const BoxStudy& study) {
  std::string text = "clip,method,frame,x_px,y_px,error_px\n";
  const auto add = [&](const BoxClipFigures& figures, const std::string& method,
                       const Found& found) {
    for (std::size_t k = 0; k < found.size(); ++k) {
      text += fmt::format("{},{},{},", csvCell(figures.clip), csvCell(method), k);
      text += found[k] ? fmt::format("{},{},{}\n", found[k]->center().x(), found[k]->center().y(),
                                     errorAt(found, figures.truth, k))
                       : ",,\n";
    }
  };
  for (const BoxClipFigures& figures : study.figures) {
    add(figures, "truth", Found(figures.truth.begin(), figures.truth.end()));
    for (const BoxStudyRow& row : study.rows) {
      if (row.clip == figures.clip) {
        add(figures, row.method, row.boxes);
      }
    }
  }
  return text;
}

} // namespace dewpoint::experiment
