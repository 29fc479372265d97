// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/recorded_run.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <memory>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <string>
#include <vector>

namespace dewpoint::app {

/// An object of Python that keeps `owner` alive: the base of arrays over its memory.
pybind11::capsule keeping(std::shared_ptr<const void> owner);

/// A read-only array over memory that `base` keeps alive; no copy.
template <class T>
pybind11::array_t<T> viewOf(const T* data, std::vector<pybind11::ssize_t> shape,
                            const pybind11::object& base) {
  pybind11::array_t<T> array(std::move(shape), data, base);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// An array of its own.
pybind11::array_t<double> arrayOf(const Eigen::Vector3d& vector);
pybind11::array_t<double> arrayOf(const Eigen::Matrix3d& matrix);
/// Particles as (positions, weights), N x 3 and N.
pybind11::tuple arraysOf(ParticleSample particles);

/// The pixels of an image (height x width x 3, blue green red, read-only) without a copy; None of
/// an empty one.
pybind11::object arrayOf(const cv::Mat& image);

/// The image of an array (height x width x 3, uint8) whose channels are in this order, "bgr" or
/// "rgb". Its pixels are not copied where they lie row by row as blue green red and no copy is
/// wanted; the array lives as long as the image. An empty image of None.
cv::Mat imageOf(const pybind11::object& array, const std::string& order, bool copy);

} // namespace dewpoint::app
