// SPDX-License-Identifier: GPL-3.0-or-later
// The entry of libFuzzer. Each program is compiled with the name of its reader.
#include "tests/fuzz/fuzzed_readers.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  dewpoint::tests::DEWPOINT_FUZZED_READER({reinterpret_cast<const char*>(bytes), count});
  return 0;
}
