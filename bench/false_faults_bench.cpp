// SPDX-License-Identifier: GPL-3.0-or-later
// How often a calibration names a fault that is not there, and how often it names one that is:
// simulated rigs of two to five cameras, with a waved stick and with a board, clean and with faults
// planted, alone and in pairs. Usage: false_faults_bench [clean|alone|pairs|real] [first seed]
// [number of rigs] [-v]; `real` checks the board recordings of DEWPOINT_DATA, which have no fault.
#include "bench/board_recording.h"
#include "core/calibration/quality/fault_finder.h"
#include "core/setup/calibration/board_calibration.h"
#include "tests/calibration/waved_rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::bench {
namespace {

namespace waved = tests::simulated;

constexpr int kWaveFrames = 300;          ///< 20 s
constexpr double kInitialDistance = 0.1;  ///< meters that initial cameras are off
constexpr double kInitialRotation = 0.05; ///< radians
constexpr int kDelayFrames = 10;          ///< of a planted delay
constexpr double kZoom = 1.12;            ///< of a planted change of the focal length
constexpr double kResolution = 2.0;       ///< of planted lens data for another image size
constexpr double kSquare = 1.25;          ///< of a board described too large
constexpr double kMovedMeters = 0.03;     ///< of a camera that is moved halfway
constexpr double kMovedRadians = 0.02;    ///< of the same camera
constexpr double kHalfPixel = 0.5;        ///< pixels

int camerasOf(std::uint64_t seed) {
  return 2 + static_cast<int>(seed % 4);
}

/// What was found, of how many.
struct Count {
  int rigs = 0;
  int named = 0; ///< the right fault, or one of the right ones, of the right cameras
  int silent = 0;
  int wrong = 0; ///< another fault, or of other cameras
};

/// Fault that is planted.
struct Planted {
  CalibrationFault fault;
  std::vector<std::size_t> cameras;
};

void count(const std::vector<DetectedFault>& found, const std::vector<Planted>& planted,
           Count& into) {
  const auto isPlanted = [&](const DetectedFault& one) {
    return std::ranges::any_of(planted, [&](const Planted& real) {
      return real.fault == one.fault && real.cameras == one.cameras;
    });
  };
  ++into.rigs;
  into.silent += found.empty() ? 1 : 0;
  into.named += std::ranges::any_of(found, isPlanted) ? 1 : 0;
  into.wrong += std::ranges::all_of(found, isPlanted) ? 0 : 1;
}

void print(const std::string& what, const Count& of) {
  fmt::print("{:<44} {:>4} rigs: {:>3} named, {:>3} silent, {:>3} wrong\n", what, of.rigs, of.named,
             of.silent, of.wrong);
  std::fflush(stdout);
}

/// Stick that is waved in front of a rig.
struct Wave {
  CameraRig truth;
  WandProblem problem;
  std::uint32_t seed = 0;
  double noise = 0.1; ///< pixels
};

Wave wave(std::uint64_t seed, int cameras) {
  Wave one;
  one.seed = static_cast<std::uint32_t>(seed);
  one.noise = 0.1 + 0.1 * static_cast<double>(seed / 4 % 4);
  one.truth = waved::rig(one.seed, cameras);
  one.problem = waved::wave(one.truth, one.seed, one.noise, kWaveFrames);
  one.problem.initialRig = waved::moved(one.truth, kInitialDistance, kInitialRotation, one.seed);
  return one;
}

std::vector<DetectedFault> faultsOf(const WandProblem& problem) {
  const auto report = findWandFaults(problem);
  return report ? report->faults : std::vector<DetectedFault>{};
}

/// Plants a fault in a camera of a wave; exchanges it with the camera `other`.
using Plant = std::function<Planted(Wave&, std::size_t camera, std::size_t other)>;

/// The images of one camera, as taken by another camera or at other times.
void replaceViews(Wave& wave, const CameraRig& rig, std::size_t camera, double later, double from) {
  std::vector<double> delays(rig.size(), 0.0);
  delays[camera] = later;
  const WandProblem other = waved::wave(rig, wave.seed, wave.noise, kWaveFrames, delays);
  auto& views = wave.problem.views[camera];
  std::erase_if(views, [&](const MarkerObservation& view) { return view.time >= from; });
  for (const MarkerObservation& view : other.views[camera]) {
    if (view.time >= from) {
      views.push_back(view);
    }
  }
}

template <typename Change> void changePixels(Wave& wave, std::size_t camera, Change change) {
  for (MarkerObservation& view : wave.problem.views[camera]) {
    view.pixel = change(view.pixel);
  }
}

/// The faults, in an order in which they can be planted one after the other: those that take the
/// images anew first.
const std::vector<std::pair<const char*, Plant>>& plants() {
  static const std::vector<std::pair<const char*, Plant>> all{
      {"camera moved",
       [](Wave& wave, std::size_t camera, std::size_t) -> Planted {
         CameraRig later = wave.truth;
         later[camera] =
             waved::moved(wave.truth, kMovedMeters, kMovedRadians, wave.seed + 50)[camera];
         replaceViews(wave, later, camera, 0.0, 0.5 * kWaveFrames / waved::kRate);
         return {CalibrationFault::CameraMoved, {camera}};
       }},
      {"camera delayed by 10 frames",
       [](Wave& wave, std::size_t camera, std::size_t) -> Planted {
         replaceViews(wave, wave.truth, camera, kDelayFrames / waved::kRate, 0.0);
         return {CalibrationFault::CameraDelayed, {camera}};
       }},
      {"zoom changed by 12 %",
       [](Wave& wave, std::size_t camera, std::size_t) -> Planted {
         CameraRig zoomed = wave.truth;
         zoomed[camera].intrinsics.focalX *= kZoom;
         zoomed[camera].intrinsics.focalY *= kZoom;
         replaceViews(wave, zoomed, camera, 0.0, 0.0);
         return {CalibrationFault::ZoomChanged, {camera}};
       }},
      {"video mirrored",
       [](Wave& wave, std::size_t camera, std::size_t) -> Planted {
         changePixels(wave, camera, [](const Eigen::Vector2d& pixel) {
           return Eigen::Vector2d(639.0 - pixel.x(), pixel.y());
         });
         return {CalibrationFault::VideoFlipped, {camera}};
       }},
      {"resolution doubled",
       [](Wave& wave, std::size_t camera, std::size_t) -> Planted {
         changePixels(wave, camera, [](const Eigen::Vector2d& pixel) {
           return Eigen::Vector2d((pixel.array() + 0.5) * kResolution - 0.5);
         });
         return {CalibrationFault::WrongResolution, {camera}};
       }},
      {"two cameras swapped",
       [](Wave& wave, std::size_t camera, std::size_t other) -> Planted {
         std::swap(wave.problem.views[camera], wave.problem.views[other]);
         return {CalibrationFault::CamerasSwapped,
                 {std::min(camera, other), std::max(camera, other)}};
       }},
      {"half a pixel",
       [](Wave& wave, std::size_t, std::size_t) -> Planted {
         for (std::size_t c = 0; c < wave.truth.size(); ++c) {
           changePixels(wave, c, [](const Eigen::Vector2d& pixel) {
             return Eigen::Vector2d(pixel.array() + kHalfPixel);
           });
         }
         return {CalibrationFault::HalfPixel, {}};
       }},
      {"length in millimeters",
       [](Wave& wave, std::size_t, std::size_t) -> Planted {
         wave.problem.stickLength *= 1000.0;
         return {CalibrationFault::WrongUnitMillimeters, {}};
       }},
  };
  return all;
}

/// The simulated board recording, with initial cameras as roughly placed by hand.
BoardRecording board(std::uint64_t seed, bool lensesKnown) {
  BoardRecording recording = simulatedRig(seed, false);
  const CameraRig rough = waved::moved(recording.truth, kInitialDistance, kInitialRotation,
                                       static_cast<std::uint32_t>(seed));
  for (std::size_t k = 0; k < rough.size(); ++k) {
    recording.project.cameras[k].camera.cameraFromWorld = rough[k].cameraFromWorld;
  }
  recording.lensesKnown = lensesKnown;
  return recording;
}

/// As the page Board does it: the lenses first, unless they are known, then the poses.
std::vector<DetectedFault> faultsOf(BoardRecording recording, bool verbose) {
  setup::BoardCalibrationRequest request;
  request.board = recording.board;
  if (!recording.lensesKnown) {
    const auto lenses = setup::intrinsicsFromBoards(recording.seen, request);
    if (!lenses) {
      fmt::print("{}: {}\n", recording.name, errorSentence(lenses.error()));
      return {};
    }
    recording.project = setup::withIntrinsics(recording.project, lenses->cameras);
  }
  const auto result = setup::extrinsicsFromBoards(recording.project, recording.seen, request);
  if (!result) {
    fmt::print("{}: {}\n", recording.name, errorSentence(result.error()));
    return {};
  }
  if (verbose) {
    fmt::print("  {}: rms {:.2f} px\n", recording.name, result->rmsPx);
  }
  return result->faults;
}

class Bench {
public:
  Bench(std::uint64_t first, int rigs, bool verbose)
      : first_(first), rigs_(rigs), verbose_(verbose) {}

  void clean() const {
    Count waves;
    Count boards;
    Count givenLenses;
    for (std::uint64_t seed = first_; seed < end(); ++seed) {
      add(fmt::format("wave {}", seed), faultsOf(wave(seed, camerasOf(seed)).problem), {}, waves);
      add(fmt::format("board {}", seed), faultsOf(board(seed, false), verbose_), {}, boards);
      add(fmt::format("board {}, given lenses", seed), faultsOf(board(seed, true), verbose_), {},
          givenLenses);
    }
    print("clean, waved stick", waves);
    print("clean, board", boards);
    print("clean, board, lenses off by 0.5 %", givenLenses);
  }

  void alone() const {
    for (const auto& [name, plant] : plants()) {
      Count found;
      for (std::uint64_t seed = first_; seed < end(); ++seed) {
        Wave one = wave(seed, 3 + static_cast<int>(seed % 3)); // two cannot tell which is wrong
        const std::size_t camera = seed % one.truth.size();
        const Planted planted = plant(one, camera, (camera + 1) % one.truth.size());
        add(fmt::format("wave {}, {}", seed, name), faultsOf(one.problem), {planted}, found);
      }
      print(name, found);
    }
    Count squares;
    for (std::uint64_t seed = first_; seed < end(); ++seed) {
      BoardRecording recording = board(seed, true);
      recording.board.squareSize *= kSquare;
      add(fmt::format("board {}, squares", seed), faultsOf(recording, verbose_),
          {{CalibrationFault::WrongSquareSize, {}}}, squares);
    }
    print("squares 25 % too large", squares);
  }

  void pairs() const {
    const auto& all = plants();
    for (std::size_t a = 0; a < all.size(); ++a) {
      for (std::size_t b = a + 1; b < all.size(); ++b) {
        Count found;
        for (std::uint64_t seed = first_; seed < end(); ++seed) {
          Wave one = wave(seed, 5);
          const std::size_t camera = seed % 5;
          const std::vector<Planted> planted{
              all[a].second(one, camera, (camera + 1) % 5),
              all[b].second(one, (camera + 2) % 5, (camera + 3) % 5)};
          add(fmt::format("wave {}, {} and {}", seed, all[a].first, all[b].first),
              faultsOf(one.problem), planted, found);
        }
        print(fmt::format("{} + {}", all[a].first, all[b].first), found);
      }
    }
  }

  void real(const char* data) const {
    for (const auto& recording : {charucoRecording(data), trayRecording(data)}) {
      if (!recording) {
        fmt::print("{}\n", errorSentence(recording.error()));
        continue;
      }
      for (const bool known : {true, false}) {
        if (known && !recording->lensesKnown) {
          continue;
        }
        BoardRecording one = *recording;
        one.lensesKnown = known;
        Count found;
        add(one.name, faultsOf(one, verbose_), {}, found);
        print(fmt::format("{}, lenses {}", one.name, known ? "given" : "estimated"), found);
      }
    }
  }

private:
  std::uint64_t end() const { return first_ + static_cast<std::uint64_t>(rigs_); }

  void add(const std::string& name, const std::vector<DetectedFault>& found,
           const std::vector<Planted>& planted, Count& into) const {
    Count one;
    count(found, planted, one);
    into.rigs += one.rigs;
    into.named += one.named;
    into.silent += one.silent;
    into.wrong += one.wrong;
    if (one.wrong > 0 || (verbose_ && one.named == 0 && !planted.empty())) {
      fmt::print("  {}: {}\n", name, found.empty() ? "nothing named" : "");
      for (const DetectedFault& fault : found) {
        fmt::print("    {} gain {:.0f}: {}\n", faultName(fault.fault), fault.logLikelihoodGain,
                   fault.sentence);
      }
      std::fflush(stdout);
    }
  }

  std::uint64_t first_;
  int rigs_;
  bool verbose_;
};

} // namespace
} // namespace dewpoint::bench

int main(int count, char** arguments) {
  const std::vector<std::string_view> words(arguments + 1, arguments + count);
  const auto number = [&](std::size_t at, int otherwise) {
    return words.size() > at ? std::atoi(words[at].data()) : otherwise;
  };
  const std::string_view mode = words.empty() ? "clean" : words.front();
  const dewpoint::bench::Bench bench(static_cast<std::uint64_t>(number(1, 1000)), number(2, 100),
                                     std::ranges::find(words, "-v") != words.end());
  const char* data = std::getenv("DEWPOINT_DATA");
  if (mode == "clean") {
    bench.clean();
  } else if (mode == "alone") {
    bench.alone();
  } else if (mode == "pairs") {
    bench.pairs();
  } else if (mode == "real" && data != nullptr) {
    bench.real(data);
  } else {
    fmt::print("usage: false_faults_bench clean|alone|pairs|real [first seed] [rigs] [-v]; real "
               "needs DEWPOINT_DATA\n");
    return 2;
  }
  return 0;
}
