// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// A matrix as OpenCV's FileStorage writes it in YAML, each line after `indent`.
std::string matrixNode(const std::string& indent, const std::string& key,
                       const Eigen::MatrixXd& matrix);

/// The values as one row.
Eigen::MatrixXd rowOf(const std::vector<double>& values);

} // namespace dewpoint::calibration
