// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Text of a matrix in the YAML of OpenCV's FileStorage, with each line after `indent`.
std::string matrixNode(const std::string& indent, const std::string& key,
                       const Eigen::MatrixXd& matrix);

/// Matrix with the values as its only row.
Eigen::MatrixXd rowOf(const std::vector<double>& values);

} // namespace dewpoint::calibration
