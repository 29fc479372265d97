// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/borrowed_image.h"

#include <utility>

namespace dewpoint::capture {
namespace {

/// Releases the owner of pixels where OpenCV would free its own memory. What is allocated by it
/// otherwise is as everywhere.
class BorrowingAllocator final : public cv::MatAllocator {
public:
  cv::UMatData* allocate(int dimensions, const int* sizes, int type, void* data, std::size_t* step,
                         cv::AccessFlag flags, cv::UMatUsageFlags usage) const override {
    return cv::Mat::getStdAllocator()->allocate(dimensions, sizes, type, data, step, flags, usage);
  }
  bool allocate(cv::UMatData* data, cv::AccessFlag flags, cv::UMatUsageFlags usage) const override {
    return cv::Mat::getStdAllocator()->allocate(data, flags, usage);
  }
  void deallocate(cv::UMatData* data) const override {
    delete static_cast<std::shared_ptr<void>*>(data->userdata);
    data->userdata = nullptr;
    delete data;
  }
};

} // namespace

cv::Mat borrowedImage(int width, int height, std::uint8_t* pixels, std::size_t stride,
                      std::shared_ptr<void> owner) {
  static BorrowingAllocator allocator; // outlives what it has to release
  cv::Mat image(height, width, CV_8UC3, pixels, stride);
  auto* const shared = new cv::UMatData(&allocator);
  shared->data = pixels;
  shared->origdata = pixels;
  shared->size = stride * static_cast<std::size_t>(height);
  shared->userdata = new std::shared_ptr<void>(std::move(owner));
  image.u = shared;
  image.addref();
  return image;
}

} // namespace dewpoint::capture
