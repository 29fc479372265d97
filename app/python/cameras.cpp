// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "core/geometry/projector.h"
#include "core/project/project.h"

#include <fmt/format.h>

#include <limits>
#include <string>

namespace py = pybind11;

namespace dewpoint::app {
namespace {

py::array_t<double> matrixOf(const ProjectCamera& camera) {
  const Intrinsics& in = camera.camera.intrinsics;
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  matrix << in.focalX, 0.0, in.centerX, 0.0, in.focalY, in.centerY, 0.0, 0.0, 1.0;
  return toArray(matrix);
}

py::array_t<double> distortionOf(const ProjectCamera& camera) {
  return py::array_t<double>(static_cast<py::ssize_t>(camera.camera.distortion.size()),
                             camera.camera.distortion.data());
}

py::array_t<double> poseOf(const ProjectCamera& camera) {
  const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> pose = camera.camera.cameraFromWorld.matrix();
  return py::array_t<double>({4, 4}, pose.data());
}

/// Pixels (N x 2) of points (N x 3, meters, world); NaN of what the camera cannot show.
py::array_t<double>
pixelsOf(const ProjectCamera& camera,
         const py::array_t<double, py::array::c_style | py::array::forcecast>& points) {
  if (points.ndim() != 2 || points.shape(1) != 3) {
    throw py::value_error("points: an array of N x 3 is expected");
  }
  const Projector projector(camera.camera);
  const auto in = points.unchecked<2>();
  py::array_t<double> pixels({points.shape(0), static_cast<py::ssize_t>(2)});
  auto out = pixels.mutable_unchecked<2>();
  for (py::ssize_t k = 0; k < points.shape(0); ++k) {
    const auto pixel = projector.project({in(k, 0), in(k, 1), in(k, 2)});
    constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
    out(k, 0) = pixel ? pixel->x() : kNowhere;
    out(k, 1) = pixel ? pixel->y() : kNowhere;
  }
  return pixels;
}

} // namespace

void bindCameras(py::module_& module) {
  py::class_<ProjectCamera>(module, "Camera", "A camera of a project and its calibration.")
      .def_property_readonly(
          "name", [](const ProjectCamera& camera) { return camera.camera.name; }, "Its name.")
      .def_readonly("source", &ProjectCamera::location,
                    "The video, folder of images, device or address; \"\" of a simulated one.")
      .def_property_readonly(
          "size",
          [](const ProjectCamera& camera) {
            const Intrinsics& in = camera.camera.intrinsics;
            return py::make_tuple(in.width, in.height);
          },
          "Width and height of its images, pixels.")
      .def_property_readonly("matrix", matrixOf, "Focal lengths and image center, 3 x 3, pixels.")
      .def_property_readonly("distortion", distortionOf,
                             "Coefficients as OpenCV has them: k1 k2 p1 p2 k3 k4 k5 k6, or k1 k2 "
                             "k3 k4 and zeros of a fisheye.")
      .def_property_readonly(
          "fisheye",
          [](const ProjectCamera& camera) { return camera.camera.lens == LensModel::Fisheye; },
          "Whether the distortion is that of a fisheye.")
      .def_property_readonly("camera_from_world", poseOf,
                             "4 x 4: takes points of the world (meters, z up) to the camera's "
                             "axes, x right, y down, z forward.")
      .def_property_readonly(
          "center", [](const ProjectCamera& camera) { return toArray(camera.camera.center()); },
          "Where it stands, meters.")
      .def("project", pixelsOf, py::arg("points"),
           "The pixels (N x 2) at which it shows points (N x 3, meters); NaN where it cannot.")
      .def("__repr__", [](const ProjectCamera& camera) {
        return fmt::format("<dewpoint.Camera {}, {}x{}>", camera.camera.name,
                           camera.camera.intrinsics.width, camera.camera.intrinsics.height);
      });
}

} // namespace dewpoint::app
