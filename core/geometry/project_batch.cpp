// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/vector_kernel.h"
#include "core/geometry/camera.h"

#include <limits>

namespace dewpoint::geometry {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

template <bool Distorted> struct ProjectKernel {
  DEWPOINT_KERNEL void run(const Projection* projection, std::int64_t count,
                           const double* __restrict x, const double* __restrict y,
                           const double* __restrict z, double* __restrict column,
                           double* __restrict row) {
    const Projection model = *projection;
    for (std::int64_t i = 0; i < count; ++i) {
      const auto pixel = model.pixel<Distorted>(x[i], y[i], z[i]);
      column[i] = pixel.visible ? pixel.column : kNowhere;
      row[i] = pixel.visible ? pixel.row : kNowhere;
    }
  }
};

} // namespace

void Projector::projectBatch(std::int64_t count, const double* x, const double* y, const double* z,
                             double* column, double* row) const {
  if (lens_ == LensModel::Fisheye) {
    for (std::int64_t i = 0; i < count; ++i) {
      const auto pixel = projection_.fisheyePixel(x[i], y[i], z[i]);
      column[i] = pixel.visible ? pixel.column : kNowhere;
      row[i] = pixel.visible ? pixel.row : kNowhere;
    }
  } else if (distorted_) {
    runKernel<ProjectKernel<true>>(&projection_, count, x, y, z, column, row);
  } else {
    runKernel<ProjectKernel<false>>(&projection_, count, x, y, z, column, row);
  }
}

} // namespace dewpoint::geometry
