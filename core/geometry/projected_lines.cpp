// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/projected_lines.h"

#include <cmath>
#include <cstddef>
#include <optional>

namespace dewpoint::geometry {
namespace {

// Chosen.

constexpr double kFarOffPx = 1e4;    ///< from the image's corner, where nobody looks
constexpr int kPiecesOfLine = 64;    ///< each is straight enough for the lenses there are
constexpr int kPiecesOfRay = 256;    ///< more: it also passes close by the camera
constexpr int kBisections = 30;      ///< for the end of what is seen: to 1e-9 of a piece
constexpr double kRayReach = 1000.0; ///< meters, as far as clicks are taken to lie
constexpr double kRayMiddle = 1.0;   ///< meters, half of the pieces lie nearer

/// The image of the curve `pointAt` over [0, 1].
template <class PointAt>
std::vector<ImageLine> projectedCurve(const Projector& projector, const PointAt& pointAt,
                                      int pieces) {
  const auto pixelAt = [&](double share) -> std::optional<Eigen::Vector2d> {
    const auto pixel = projector.project(pointAt(share));
    return pixel && pixel->cwiseAbs().maxCoeff() <= kFarOffPx ? pixel : std::nullopt;
  };
  // The last pixel seen on the way from a share that is seen to one that is not.
  const auto borderFrom = [&](double seen, double unseen) {
    for (int k = 0; k < kBisections; ++k) {
      const double middle = 0.5 * (seen + unseen);
      (pixelAt(middle) ? seen : unseen) = middle;
    }
    return *pixelAt(seen);
  };
  std::vector<ImageLine> lines;
  bool wasSeen = false;
  for (int k = 0; k <= pieces; ++k) {
    const double share = static_cast<double>(k) / pieces;
    const double before = static_cast<double>(k - 1) / pieces;
    const auto pixel = pixelAt(share);
    if (pixel && !wasSeen) {
      lines.emplace_back();
      if (k > 0) {
        lines.back().push_back(borderFrom(share, before));
      }
    } else if (!pixel && wasSeen) {
      lines.back().push_back(borderFrom(before, share));
    }
    if (pixel) {
      lines.back().push_back(*pixel);
    }
    wasSeen = pixel.has_value();
  }
  std::erase_if(lines, [](const ImageLine& line) { return line.size() < 2; });
  return lines;
}

} // namespace

std::array<std::pair<Eigen::Vector3d, Eigen::Vector3d>, 12> edgesOf(const WorldBox& box) {
  const auto corner = [&](unsigned k) {
    return Eigen::Vector3d((k & 1U) != 0 ? box.max.x() : box.min.x(),
                           (k & 2U) != 0 ? box.max.y() : box.min.y(),
                           (k & 4U) != 0 ? box.max.z() : box.min.z());
  };
  std::array<std::pair<Eigen::Vector3d, Eigen::Vector3d>, 12> edges;
  std::size_t count = 0;
  for (unsigned k = 0; k < 8; ++k) {
    for (const unsigned along : {1U, 2U, 4U}) {
      if ((k & along) == 0) {
        edges[count++] = {corner(k), corner(k | along)};
      }
    }
  }
  return edges;
}

std::vector<ImageLine> projectLine(const Projector& projector, const Eigen::Vector3d& from,
                                   const Eigen::Vector3d& to) {
  const auto pointAt = [&](double share) { return Eigen::Vector3d(from + share * (to - from)); };
  return projectedCurve(projector, pointAt, kPiecesOfLine);
}

std::vector<ImageLine> projectEdges(const Projector& projector, const WorldBox& box) {
  std::vector<ImageLine> lines;
  for (const auto& [from, to] : edgesOf(box)) {
    for (ImageLine& line : projectLine(projector, from, to)) {
      lines.push_back(std::move(line));
    }
  }
  return lines;
}

std::vector<ImageLine> projectRay(const Projector& projector, const Ray& ray) {
  // Steps that grow with the depth, as the image of a ray shrinks with it.
  constexpr double kLast = kRayReach / (kRayReach + kRayMiddle);
  const auto pointAt = [&](double share) {
    const double part = share * kLast;
    return Eigen::Vector3d(ray.origin + kRayMiddle * part / (1.0 - part) * ray.direction);
  };
  return projectedCurve(projector, pointAt, kPiecesOfRay);
}

} // namespace dewpoint::geometry
