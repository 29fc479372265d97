// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/boxes/target_map.h"

#include "core/color/rgb_bins.h"

#include <algorithm>

namespace dewpoint::observation {

void TargetMap::build(const cv::Mat& bgr, const cv::Rect& region, const TargetColors& colors) {
  region_ = region & cv::Rect({0, 0}, bgr.size());
  const auto columns = std::size_t(region_.width) + 1;
  std::array<BinShares, TargetColors::kPartCount> shares;
  for (std::size_t part = 0; part < shares.size(); ++part) {
    shares[part] = colors.binShares(static_cast<int>(part));
    integrals_[part].assign(columns * (std::size_t(region_.height) + 1), 0);
  }
  std::vector<std::uint16_t> bins(columns);
  for (int row = 0; row < region_.height; ++row) {
    const auto* from = bgr.ptr<cv::Vec3b>(region_.y + row) + region_.x;
    for (int x = 0; x < region_.width; ++x) {
      bins[std::size_t(x)] = fineRgbBin(from[x][0], from[x][1], from[x][2]);
    }
    for (std::size_t part = 0; part < shares.size(); ++part) {
      const std::uint32_t* above = integrals_[part].data() + std::size_t(row) * columns + 1;
      std::uint32_t* below = integrals_[part].data() + std::size_t(row + 1) * columns + 1;
      std::uint32_t sum = 0;
      for (int x = 0; x < region_.width; ++x) {
        sum += shares[part][bins[std::size_t(x)]];
        below[x] = above[x] + sum;
      }
    }
  }
}

double TargetMap::corner(const Integral& integral, double x, double y) const {
  const double right = std::clamp(x - region_.x, 0.0, double(region_.width));
  const double down = std::clamp(y - region_.y, 0.0, double(region_.height));
  const int column = std::min(static_cast<int>(right), region_.width - 1);
  const int row = std::min(static_cast<int>(down), region_.height - 1);
  const auto stride = std::size_t(region_.width) + 1;
  const std::uint32_t* at = integral.data() + std::size_t(row) * stride + std::size_t(column);
  const double fx = right - column;
  const double fy = down - row;
  const double top = at[0] + fx * double(at[1] - at[0]);
  const double bottom = at[stride] + fx * double(at[stride + 1] - at[stride]);
  return top + fy * (bottom - top);
}

double TargetMap::sum(const ImageBox& box) const {
  if (region_.empty()) {
    return 0.0;
  }
  double total = 0.0;
  for (int part = 0; part < TargetColors::kPartCount; ++part) {
    const ImageBox piece = TargetColors::partOf(box, part);
    const Integral& integral = integrals_[std::size_t(part)];
    const double right = piece.x + piece.width;
    const double bottom = piece.y + piece.height;
    total += corner(integral, right, bottom) - corner(integral, piece.x, bottom) -
             corner(integral, right, piece.y) + corner(integral, piece.x, piece.y);
  }
  return total / TargetColors::kFixedPointOne;
}

} // namespace dewpoint::observation
