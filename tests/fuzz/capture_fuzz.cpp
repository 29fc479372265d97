// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/capture_times.h"
#include "core/capture/gstreamer/pipeline_text.h"
#include "tests/fuzz/expectation.h"
#include "tests/fuzz/fuzzed_readers.h"
#include "tests/fuzz/input_file.h"

#include <algorithm>
#include <string>

namespace dewpoint::tests {

void fuzzCaptureTimes(std::string_view bytes) {
  static const InputFile kFile("times.csv");
  const auto times = readCaptureTimes(kFile.hold(bytes).string(), {"left", "0"}, "camera left");
  if (!times) {
    expectPlain(times.error());
  } else {
    expect(!times->empty() && std::ranges::is_sorted(*times), "times that do not rise");
  }
}

void fuzzCameraLocation(std::string_view bytes) {
  capture::LiveCamera camera;
  camera.name = "left";
  camera.location = std::string(bytes);
  auto pipeline = capture::pipelineText(camera);
  if (!pipeline) {
    if (camera.location.empty()) {
      pipeline.error().file = "camera"; // its field is all that there is to name
    }
    expectPlain(pipeline.error());
  } else {
    expect(!pipeline->text.empty(), "an empty pipeline");
  }
}

} // namespace dewpoint::tests
