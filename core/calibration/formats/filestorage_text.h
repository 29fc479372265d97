// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Returns the text of a matrix in the YAML dialect of OpenCV's FileStorage, with `indent` at the
/// start of each line.
std::string matrixNodeText(const std::string& indent, const std::string& key,
                           const Eigen::MatrixXd& matrix);

/// Returns `values` as a matrix with a single row.
Eigen::MatrixXd rowMatrix(const std::vector<double>& values);

} // namespace dewpoint::calibration
