// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/arrays.h"

#include "app/python/python_error.h"
#include "core/capture/borrowed_image.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <utility>

namespace py = pybind11;

namespace dewpoint::app {
namespace {

constexpr py::ssize_t kChannels = 3;

/// Releases an object of Python in whatever thread the last image of it goes.
std::shared_ptr<void> ownerOf(const py::object& object) {
  return {object.inc_ref().ptr(), [](void* held) {
            if (Py_IsInitialized() != 0) {
              const py::gil_scoped_acquire gil;
              Py_DECREF(static_cast<PyObject*>(held));
            }
          }};
}

/// Whether the pixels of a row lie one behind the other, and the rows in their order.
bool liesRowByRow(const py::array& array) {
  return array.strides(2) == 1 && array.strides(1) == kChannels &&
         array.strides(0) >= kChannels * array.shape(1);
}

} // namespace

py::capsule keepAliveCapsule(std::shared_ptr<const void> owner) {
  return py::capsule(new std::shared_ptr<const void>(std::move(owner)),
                     [](void* held) { delete static_cast<std::shared_ptr<const void>*>(held); });
}

py::array_t<double> toArray(const Eigen::Vector3d& vector) {
  return py::array_t<double>(3, vector.data());
}

py::array_t<double> toArray(const Eigen::Matrix3d& matrix) {
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = matrix;
  return py::array_t<double>({3, 3}, rows.data());
}

py::tuple toArrays(ParticleSample particles) {
  const auto kept = std::make_shared<const ParticleSample>(std::move(particles));
  const py::capsule base = keepAliveCapsule(kept);
  return py::make_tuple(
      arrayView(kept->positions.data(), {static_cast<py::ssize_t>(kept->positions.rows()), 3},
                base),
      arrayView(kept->weights.data(), {static_cast<py::ssize_t>(kept->weights.size())}, base));
}

py::object toArray(const cv::Mat& image) {
  if (image.empty()) {
    return py::none();
  }
  const auto kept = std::make_shared<const cv::Mat>(image); // shares the pixels
  py::array_t<std::uint8_t> array(
      {static_cast<py::ssize_t>(image.rows), static_cast<py::ssize_t>(image.cols), kChannels},
      {static_cast<py::ssize_t>(image.step[0]), kChannels, static_cast<py::ssize_t>(1)}, kept->data,
      keepAliveCapsule(kept));
  array.attr("flags").attr("writeable") = false;
  return array;
}

cv::Mat toImage(const py::object& object, const std::string& order, bool copy) {
  if (order != "bgr" && order != "rgb") {
    raiseBadValue("order", "one of bgr, rgb; not " + order);
  }
  if (object.is_none()) {
    return {};
  }
  const bool isArray = py::isinstance<py::array>(object);
  auto array = isArray ? py::reinterpret_borrow<py::array>(object) : py::array();
  if (!isArray || array.dtype().kind() != 'u' || array.itemsize() != 1 || array.ndim() != 3 ||
      array.shape(2) != kChannels || array.size() == 0) {
    raiseBadValue("images", "arrays of uint8, height x width x 3, are expected");
  }
  if (!liesRowByRow(array)) {
    array = py::array_t<std::uint8_t, py::array::c_style>::ensure(array);
  }
  const auto height = static_cast<int>(array.shape(0));
  const auto width = static_cast<int>(array.shape(1));
  // Images are only read.
  auto* const pixels = const_cast<std::uint8_t*>(static_cast<const std::uint8_t*>(array.data()));
  const auto stride = static_cast<std::size_t>(array.strides(0));
  if (order == "rgb") {
    cv::Mat image;
    cv::cvtColor(cv::Mat(height, width, CV_8UC3, pixels, stride), image, cv::COLOR_RGB2BGR);
    return image;
  }
  return copy ? cv::Mat(height, width, CV_8UC3, pixels, stride).clone()
              : borrowedImage(width, height, pixels, stride, ownerOf(array));
}

} // namespace dewpoint::app
