#include <cstdint>
#include <emscripten.h>
#include <flint/flint.h>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wasm/binding/requests.h"

/// The functions that the module exports. JavaScript writes the parts of a request where epsnet_new_input says, the
/// JSON first, then the files; calls epsnet_ask; and reads the parts of the answer. Addresses and sizes are numbers of
/// 32 bits, as the memory of the module has 4 GiB at most.
///
/// The code is compiled for 64-bit long and pointers, as GMP and FLINT were written for, and lowered to 32-bit memory.
static_assert(sizeof(long) == 8 && sizeof(void*) == 8 && FLINT_BITS == 64);

namespace {

using epsnet::wasm::Answer;
using epsnet::wasm::Request;

std::vector<std::string> inputs;
std::vector<std::string> outputs;

std::uint32_t address(const std::string& bytes) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(bytes.data()));
}

EM_JS(void, show_progress, (std::uint32_t text, std::uint32_t size, double share), {
  if (Module.progress) Module.progress(UTF8ToString(text >>> 0, size >>> 0), share);
});

Answer ask() {
  std::vector<std::string> files = std::exchange(inputs, {});
  const std::string json = files.empty() ? "" : std::move(files.front());
  if (!files.empty()) files.erase(files.begin());
  epsnet::Json what = epsnet::Json::parse(json, nullptr, false);
  return answer(Request{std::move(what), std::move(files)}, [](std::string_view text, double share) {
    show_progress(static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(text.data())),
                  static_cast<std::uint32_t>(text.size()), share);
  });
}

}  // namespace

extern "C" {

/// Returns where the next part of the request, of this many bytes, is to be written; 0 if there is no memory for it.
EMSCRIPTEN_KEEPALIVE std::uint32_t epsnet_new_input(std::uint32_t size) {
  try {
    return address(inputs.emplace_back(size, '\0'));
  } catch (const std::bad_alloc&) {
    inputs.clear();
    return 0;
  }
}

/// Answers the request. Returns the number of parts of the answer, or 0 if there is no memory for one.
EMSCRIPTEN_KEEPALIVE std::uint32_t epsnet_ask() {
  try {
    Answer answer = ask();
    outputs = std::move(answer.files);
    outputs.insert(outputs.begin(), std::move(answer.json));
    return static_cast<std::uint32_t>(outputs.size());
  } catch (const std::bad_alloc&) {
    outputs.clear();
    return 0;
  }
}

/// Returns where part `number` of the answer is.
EMSCRIPTEN_KEEPALIVE std::uint32_t epsnet_output(std::uint32_t number) { return address(outputs.at(number)); }
/// Returns how many bytes it has.
EMSCRIPTEN_KEEPALIVE std::uint32_t epsnet_output_size(std::uint32_t number) {
  return static_cast<std::uint32_t>(outputs.at(number).size());
}
/// Gives the memory of the answer back.
EMSCRIPTEN_KEEPALIVE void epsnet_forget() { outputs = {}; }
}
