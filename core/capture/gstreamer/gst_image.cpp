// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/gst_image.h"

#include <fmt/format.h>

#include <cstring>
#include <gst/gst.h>
#include <gst/video/video.h>
#include <memory>

namespace dewpoint::capture {
namespace {

cv::Mat copied(GstVideoFrame& frame) {
  cv::Mat image(GST_VIDEO_FRAME_HEIGHT(&frame), GST_VIDEO_FRAME_WIDTH(&frame), CV_8UC3);
  const cv::Mat mapped(image.size(), CV_8UC3, GST_VIDEO_FRAME_PLANE_DATA(&frame, 0),
                       static_cast<std::size_t>(GST_VIDEO_FRAME_PLANE_STRIDE(&frame, 0)));
  mapped.copyTo(image);
  return image;
}

cv::Mat converted(GstVideoFrame& frame) {
  const int width = GST_VIDEO_FRAME_WIDTH(&frame);
  const int height = GST_VIDEO_FRAME_HEIGHT(&frame);
  GstVideoInfo wanted;
  gst_video_info_init(&wanted);
  if (gst_video_info_set_format(&wanted, GST_VIDEO_FORMAT_BGR, static_cast<guint>(width),
                                static_cast<guint>(height)) == FALSE) {
    return {};
  }
  wanted.fps_n = frame.info.fps_n; // a converter changes neither
  wanted.fps_d = frame.info.fps_d;
  wanted.interlace_mode = frame.info.interlace_mode;
  const std::unique_ptr<GstVideoConverter, void (*)(GstVideoConverter*)> converter(
      gst_video_converter_new(&frame.info, &wanted, nullptr), gst_video_converter_free);
  GstBuffer* buffer = gst_buffer_new_allocate(nullptr, wanted.size, nullptr);
  cv::Mat image;
  GstVideoFrame target;
  if (converter && gst_video_frame_map(&target, &wanted, buffer, GST_MAP_READWRITE) != FALSE) {
    gst_video_converter_frame(converter.get(), &frame, &target);
    image = copied(target);
    gst_video_frame_unmap(&target);
  }
  gst_buffer_unref(buffer);
  return image;
}

} // namespace

std::string storedFormatOf(_GstSample& sample) {
  GstCaps* caps = gst_sample_get_caps(&sample);
  if (caps == nullptr || gst_caps_get_size(caps) == 0) {
    return {};
  }
  const GstStructure* structure = gst_caps_get_structure(caps, 0);
  std::string format = gst_structure_get_name(structure);
  for (const char* field : {"format", "width", "height", "stream-format", "codec_data"}) {
    if (const GValue* value = gst_structure_get_value(structure, field)) {
      gchar* text = gst_value_serialize(value);
      format += fmt::format(" {}={}", field, text != nullptr ? text : "?");
      g_free(text);
    }
  }
  return format;
}

std::string mediaTypeOf(_GstSample& sample) {
  GstCaps* caps = gst_sample_get_caps(&sample);
  return caps != nullptr && gst_caps_get_size(caps) > 0
             ? gst_structure_get_name(gst_caps_get_structure(caps, 0))
             : "";
}

cv::Mat imageOf(_GstSample& sample) {
  GstCaps* caps = gst_sample_get_caps(&sample);
  GstBuffer* buffer = gst_sample_get_buffer(&sample);
  GstVideoInfo info;
  GstVideoFrame frame;
  if (caps == nullptr || buffer == nullptr || mediaTypeOf(sample) != "video/x-raw" ||
      gst_video_info_from_caps(&info, caps) == FALSE ||
      gst_video_frame_map(&frame, &info, buffer, GST_MAP_READ) == FALSE) {
    return {};
  }
  cv::Mat image =
      GST_VIDEO_INFO_FORMAT(&info) == GST_VIDEO_FORMAT_BGR ? copied(frame) : converted(frame);
  gst_video_frame_unmap(&frame);
  return image;
}

_GstSample* sampleOf(const cv::Mat& image) {
  // Rows of GStreamer's images begin at multiples of four bytes.
  const std::size_t row = (static_cast<std::size_t>(image.cols) * 3 + 3) / 4 * 4;
  const std::size_t size = row * static_cast<std::size_t>(image.rows);
  GstBuffer* buffer = gst_buffer_new_allocate(nullptr, size, nullptr);
  GstMapInfo map;
  if (gst_buffer_map(buffer, &map, GST_MAP_WRITE) != FALSE) {
    std::memset(map.data, 0, size);
    image.copyTo(cv::Mat(image.size(), CV_8UC3, map.data, row));
    gst_buffer_unmap(buffer, &map);
  }
  GstCaps* caps = gst_caps_new_simple("video/x-raw", "format", G_TYPE_STRING, "BGR", "width",
                                      G_TYPE_INT, image.cols, "height", G_TYPE_INT, image.rows,
                                      "framerate", GST_TYPE_FRACTION, 0, 1, nullptr);
  GstSample* sample = gst_sample_new(buffer, caps, nullptr, nullptr);
  gst_caps_unref(caps);
  gst_buffer_unref(buffer);
  return sample;
}

} // namespace dewpoint::capture
