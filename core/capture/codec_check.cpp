// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/codec_check.h"

#include "core/capture/frame_writer.h"
#include "core/capture/image_reader.h"
#include "core/capture/video_reader.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include <algorithm>
#include <array>

namespace dewpoint::capture {
namespace {

constexpr int kCheckFrames = 12;
constexpr double kCheckRate = 25.0;
/// Gray values by which a lossy codec may be off in the mean. A judgment: far more than any is, far
/// less than another frame or other colors would be.
constexpr double kLossyDifference = 6.0;

cv::Mat checkImage(int frame) {
  cv::Mat image(120, 160, CV_8UC3, cv::Scalar(60, 110, 90));
  cv::circle(image, {30 + 8 * frame, 60}, 20, cv::Scalar(40, 40, 210), cv::FILLED);
  return image;
}

struct CheckedCodec {
  const char* name;
  bool isNeeded;
  bool isLossless;
  const char* file;
  std::array<char, 4> code; ///< of lossy videos
};

constexpr std::array kCheckedCodecs{
    CheckedCodec{"MJPG", false, false, "check.avi", {'M', 'J', 'P', 'G'}},
    CheckedCodec{"FFV1", true, true, "check.mkv", {}},
    CheckedCodec{"H.264", false, false, "check.mp4", {'a', 'v', 'c', '1'}},
    CheckedCodec{"PNG folder", true, true, "check", {}},
};

bool isFolderOf(const CheckedCodec& codec) {
  return std::string_view(codec.file).find('.') == std::string_view::npos;
}

Status writeLossless(const CheckedCodec& codec, const std::string& file) {
  auto writer = isFolderOf(codec) ? FrameWriter::createImageFolder(file)
                                  : FrameWriter::createVideo(file, kCheckRate);
  if (!writer) {
    return tl::make_unexpected(writer.error());
  }
  for (int frame = 0; frame < kCheckFrames; ++frame) {
    if (auto written = writer->write(checkImage(frame)); !written) {
      return written;
    }
  }
  return writer->finish();
}

/// False: there is no such encoder.
bool writeLossy(const CheckedCodec& codec, const std::string& file) {
  try {
    cv::VideoWriter writer;
    const auto [a, b, c, d] = codec.code;
    if (!writer.open(file, cv::CAP_FFMPEG, cv::VideoWriter::fourcc(a, b, c, d), kCheckRate,
                     checkImage(0).size())) {
      return false;
    }
    for (int frame = 0; frame < kCheckFrames; ++frame) {
      writer.write(checkImage(frame));
    }
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

void readBack(const CheckedCodec& codec, const std::string& file, CodecOutcome& outcome) {
  const auto reader =
      isFolderOf(codec) ? openImageFolderReader(file, "") : openVideoReader(file, "");
  if (!reader) {
    outcome.problem = errorSentence(reader.error());
    return;
  }
  for (int frame = 0; frame < kCheckFrames; ++frame) {
    const cv::Mat wanted = checkImage(frame);
    const auto picture = (*reader)->read(frame);
    if (!picture || picture->size() != wanted.size()) {
      outcome.problem =
          picture ? fmt::format("frame {} is missing", frame) : errorSentence(picture.error());
      return;
    }
    const double difference =
        cv::norm(*picture, wanted, cv::NORM_L1) / static_cast<double>(3 * wanted.total());
    outcome.difference = std::max(outcome.difference, difference);
  }
  if (outcome.difference > (codec.isLossless ? 0.0 : kLossyDifference)) {
    outcome.problem = fmt::format(
        "the image that was read differs from the image that was written by {:.1f} gray values",
        outcome.difference);
  }
}

} // namespace

std::vector<CodecOutcome> checkCodecs(const std::filesystem::path& folder) {
  std::vector<CodecOutcome> outcomes;
  for (const CheckedCodec& codec : kCheckedCodecs) {
    CodecOutcome& outcome = outcomes.emplace_back();
    outcome.name = codec.name;
    outcome.isNeeded = codec.isNeeded;
    outcome.isLossless = codec.isLossless;
    const std::string file = (folder / codec.file).string();
    if (codec.isLossless) {
      if (const auto written = writeLossless(codec, file); !written) {
        outcome.problem = errorSentence(written.error());
        continue;
      }
    } else if (!writeLossy(codec, file)) {
      outcome.isMissing = true;
      continue;
    }
    readBack(codec, file, outcome);
  }
  return outcomes;
}

} // namespace dewpoint::capture
