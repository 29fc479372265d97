// SPDX-License-Identifier: GPL-3.0-or-later
// What is fuzzed: each of these reads the bytes as one kind of file or message, as the program
// does, and does with the result what the program does at once. It returns whatever the bytes are:
// an error has to be one plain sentence (expectPlain()), everything else ends the process. The
// table of their names is fuzzed_readers.cpp; one that is missing there or in CMakeLists.txt is not
// run.
#pragma once

#include "core/base/floors.h"

#include <span>
#include <string_view>

namespace dewpoint::tests {

void fuzzProject(std::string_view bytes);
void fuzzScene(std::string_view bytes);
void fuzzTrajectory(std::string_view bytes);
void fuzzCaptureTimes(std::string_view bytes);
void fuzzCameraLocation(std::string_view bytes); ///< the address of a live camera
void fuzzBoard(std::string_view bytes);          ///< the text that describes a calibration board

// Calibrations: any file, then each format by its name, then files beside others.
void fuzzCalibration(std::string_view bytes);
void fuzzDewpoint(std::string_view bytes);
void fuzzAnipose(std::string_view bytes);
void fuzzPose2sim(std::string_view bytes);
void fuzzCaliscope(std::string_view bytes);
void fuzzOpencv(std::string_view bytes);
void fuzzOpencvStereo(std::string_view bytes);
void fuzzRos(std::string_view bytes);
void fuzzKalibr(std::string_view bytes);
void fuzzMrcal(std::string_view bytes);
void fuzzMcCalib(std::string_view bytes);
void fuzzQualisys(std::string_view bytes);
void fuzzMultical(std::string_view bytes);
void fuzzPlain(std::string_view bytes);
void fuzzOpencvExtrinsics(std::string_view bytes);
void fuzzRosTransforms(std::string_view bytes);

// Files of finished jobs, takes and the accuracy suite.
void fuzzJobRecord(std::string_view bytes);
void fuzzEvaluation(std::string_view bytes);
void fuzzLiveFrames(std::string_view bytes);
void fuzzTakeNotes(std::string_view bytes);
void fuzzClipTable(std::string_view bytes);
void fuzzBandCameras(std::string_view bytes);
void fuzzBoxTruth(std::string_view bytes);
void fuzzSuiteRows(std::string_view bytes);

// What comes from the network.
void fuzzRemoteLines(std::string_view bytes);
void fuzzWebRequest(std::string_view bytes);
void fuzzWebSocket(std::string_view bytes); ///< after the handshake

/// A reader, called as its folder in tests/fuzz/corpus.
struct FuzzedReader {
  const char* name;
  void (*read)(std::string_view bytes);
};
std::span<const FuzzedReader> fuzzedReaders();

} // namespace dewpoint::tests
