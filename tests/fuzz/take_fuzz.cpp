// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/take/live_run.h"
#include "core/session/take/take_replay.h"
#include "tests/fuzz/expectation.h"
#include "tests/fuzz/fuzzed_readers.h"
#include "tests/fuzz/input_file.h"

#include <algorithm>

namespace dewpoint::tests {
namespace {

/// Compares a take without a project: what is reached is the reading of its notes.
void compareTake(const std::filesystem::path& take) {
  const auto compared =
      session::compareReplay(take, 1, [](std::int64_t, std::int64_t) { return true; });
  expect(!compared, "a take without a project was compared");
  expectPlain(compared.error());
}

bool isSameSet(const session::StoredFrameSet& one, const session::StoredFrameSet& other) {
  return one.index == other.index && one.time == other.time &&
         std::ranges::equal(one.images, other.images, [](const auto& a, const auto& b) {
           return a.has_value() == b.has_value() && (!a || (a->numberInVideo == b->numberInVideo &&
                                                            a->captureTime == b->captureTime));
         });
}

} // namespace

void fuzzLiveFrames(std::string_view bytes) {
  static const InputFile kFile("frames.csv");
  constexpr std::size_t kCameras = 2;
  const auto sets = session::readStoredFrameSets(kFile.hold(bytes), kCameras);
  if (!sets) {
    expectPlain(sets.error());
    return;
  }
  // Written in place: writeStoredFrameSets() waits for the disk.
  const auto again =
      session::readStoredFrameSets(kFile.hold(session::storedFrameSetsCsv(*sets)), kCameras);
  if (!again) {
    expectPlain(again.error());
  }
  expect(again && std::ranges::equal(*again, *sets, isSameSet),
         "the frames of a live run are others when written again");
}

void fuzzTakeNotes(std::string_view bytes) {
  static const InputFile kFrames("take/live/frames.csv");
  static const InputFile kFile("take/take.json");
  static const InputFile kLive("take/live/live.json");
  // Either file can be the broken one.
  (void)kFile.hold(bytes);
  (void)kLive.hold(R"({"other_settings": []})");
  compareTake(kFile.path().parent_path());
  (void)kFile.hold(R"({"cameras": []})");
  (void)kLive.hold(bytes);
  compareTake(kFile.path().parent_path());
}

} // namespace dewpoint::tests
