// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long it takes to show a moment of a recording: `seek_bench LEFT.mp4 RIGHT.mp4` tracks the two
// videos once (method dewpoint), then goes to moments as a scrubbing hand does, and prints the time
// from the wish to the snapshot, and the memory. A video to try it with:
//   ffmpeg -f lavfi -i testsrc2=s=640x480:r=30:d=600 -c:v libx264 -preset veryfast left.mp4
#include "core/capture/recording.h"
#include "core/geometry/camera.h"
#include "core/session/session.h"
#include "core/tracking/catalog/method_catalog.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace dewpoint::bench;
using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

void print(const char* what, std::vector<double> times) {
  std::sort(times.begin(), times.end());
  const auto at = [&](double share) {
    return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
  };
  fmt::print("{:30} {:4} times: median {:6.1f} ms, 95 % {:6.1f} ms, longest {:6.1f} ms\n", what,
             times.size(), at(0.5), at(0.95), times.back());
}

double megabytes(std::size_t bytes) {
  return static_cast<double>(bytes) / (1 << 20);
}

double residentMegabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmRSS:")) {
      return std::stod(line.substr(6)) / 1024.0;
    }
  }
  return 0.0;
}

SessionInputs inputsOf(const std::vector<std::string>& videos) {
  SessionInputs inputs;
  inputs.project.name = "seek";
  inputs.project.method = "dewpoint";
  inputs.project.parameters = ParameterValues(methodParameters("dewpoint"));
  inputs.project.parameters.markAllAsGiven();
  inputs.project.targets = {{"ball", 0.03, {320.0, 352.0, 0.35, 1.0, 0.2, 0.9}}};
  std::vector<RecordedCamera> cameras;
  for (const std::string& video : videos) {
    Camera camera;
    camera.name = video;
    camera.intrinsics = {640, 480, 600.0, 600.0, 319.5, 239.5};
    const double side = cameras.empty() ? -0.6 : 0.6;
    camera.cameraFromWorld = lookAt({0.5 + side, -0.5, 0.6}, {0.5, 0.5, 0.1});
    inputs.project.cameras.push_back({camera, SourceKind::Video, video, 0});
    RecordedCamera recorded;
    recorded.name = video;
    recorded.path = video;
    cameras.push_back(recorded);
  }
  auto source = openRecording(cameras, 10000.0); // so that playing does not wait
  if (!source) {
    fmt::print(stderr, "{}\n", errorSentence(source.error()));
    std::exit(1);
  }
  inputs.source = std::move(*source);
  return inputs;
}

double cpuSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Milliseconds from the wish to the first picture of the moment, and to the true one.
struct Times {
  std::vector<double> first;
  std::vector<double> exact;
};

void show(Session& session, std::int64_t frame, Times& times) {
  const auto begin = Clock::now();
  bool seen = false;
  session.showFrame(frame);
  while (true) {
    const auto snapshot = session.newest();
    if (snapshot->frame == frame && !seen) {
      seen = true;
      times.first.push_back(millisecondsSince(begin));
    }
    if (snapshot->frame == frame && !snapshot->isPreview) {
      times.exact.push_back(millisecondsSince(begin));
      return;
    }
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
}

void print(const char* what, const Times& times) {
  fmt::print("{}\n", what);
  print("  until the moment is shown", times.first);
  print("  until its true images are", times.exact);
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "seek_bench LEFT RIGHT\n");
    return 2;
  }
  Session session(inputsOf({argv[1], argv[2]}));
  const auto begin = Clock::now();
  session.play();
  while (session.newest()->state != PlayState::Ended) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  const std::int64_t frames = session.newest()->history.newestTrackedFrame + 1;
  const HistoryState history = session.newest()->history;
  fmt::print("{} frames tracked in {:.1f} s; history {:.0f} of {:.0f} MB, process {:.0f} MB\n",
             frames, millisecondsSince(begin) / 1e3, megabytes(history.memoryBytes),
             megabytes(history.maxMemoryBytes), residentMegabytes());
  const double cpu = cpuSeconds();
  Times jumps;
  for (std::int64_t k = 1; k <= 200; ++k) {
    show(session, k * 7919 % frames, jumps); // a prime: all over the recording
  }
  print("jumps all over the recording", jumps);
  fmt::print("  processor time {:.1f} ms each\n",
             1e3 * (cpuSeconds() - cpu) / static_cast<double>(jumps.exact.size()));
  Times ahead;
  Times back;
  const std::int64_t middle = frames / 2;
  for (std::int64_t k = 0; k < 200; ++k) {
    show(session, std::min(frames - 1, middle + k), ahead);
  }
  print("one frame ahead", ahead);
  for (std::int64_t k = 0; k < 200; ++k) {
    show(session, std::max<std::int64_t>(0, middle - 300 - k), back);
  }
  print("one frame back", back);
  const auto again = Clock::now();
  const std::int64_t from = frames - std::min<std::int64_t>(frames, 1000);
  std::uint64_t generation = 0;
  std::size_t position = 0;
  session.framesSince(generation, position);
  session.rerunFrom(from);
  while (!session.framesSince(generation, position).restarted) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  while (session.trajectory().samples.size() != static_cast<std::size_t>(frames)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  fmt::print("{} frames tracked again in {:.1f} s; process {:.0f} MB\n", frames - from,
             millisecondsSince(again) / 1e3, residentMegabytes());
  return 0;
}
