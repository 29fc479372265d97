// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/filestorage_text.h"

#include "core/calibration/formats/number_text.h"

#include <fmt/format.h>

namespace dewpoint::calibration {

std::string matrixNodeText(const std::string& indent, const std::string& key,
                           const Eigen::MatrixXd& matrix) {
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows = matrix;
  return fmt::format("{0}{1}: !!opencv-matrix\n{0}   rows: {2}\n{0}   cols: {3}\n{0}   dt: d\n"
                     "{0}   data: {4}\n",
                     indent, key, matrix.rows(), matrix.cols(),
                     listText(std::span(rows.data(), std::size_t(rows.size()))));
}

Eigen::MatrixXd rowMatrix(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::RowVectorXd>(values.data(), Eigen::Index(values.size()));
}

} // namespace dewpoint::calibration
