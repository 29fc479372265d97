// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/recorded_run.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <memory>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <string>
#include <vector>

namespace dewpoint::app {

/// Returns a Python object that keeps `owner` alive, for use as the base of arrays that refer to
/// the memory of `owner`.
pybind11::capsule keepAliveCapsule(std::shared_ptr<const void> owner);

/// Returns a read-only NumPy array that refers to the memory `data` without a copy. `base` is a
/// Python object that keeps this memory alive.
template <class T>
pybind11::array_t<T> arrayView(const T* data, std::vector<pybind11::ssize_t> shape,
                               const pybind11::object& base) {
  pybind11::array_t<T> array(std::move(shape), data, base);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// Returns a NumPy array with a copy of the values.
pybind11::array_t<double> toArray(const Eigen::Vector3d& vector);
pybind11::array_t<double> toArray(const Eigen::Matrix3d& matrix);
/// Returns particles as a Python tuple (positions, weights) of arrays with shapes N x 3 (meters)
/// and N.
pybind11::tuple toArrays(ParticleSample particles);

/// Returns the pixels of an image as a read-only array (height x width x 3; blue, green, red)
/// without a copy; None for an empty image.
pybind11::object toArray(const cv::Mat& image);

/// Converts an array (height x width x 3, uint8) to an image. `order` is the channel order: "bgr"
/// or "rgb". The pixels are not copied if they are stored row by row as blue, green, red and `copy`
/// is false; the image then keeps the array alive. Returns an empty image for None.
cv::Mat toImage(const pybind11::object& array, const std::string& order, bool copy);

} // namespace dewpoint::app
